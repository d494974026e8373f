#pragma once
#include <algorithm>
#include <cstddef>
#include <string>
#include <vector>

namespace plumbline {

/// The ids of all drawings in the program's code, sorted, from its start on. Whether one is ever drawn
/// depends on the modules that run.
std::vector<std::string> drawingNames();

/// The ids that names choose, each once. A name is that of a drawing ("BallLocator:ball") or what names begin
/// with before a colon: a module ("BallLocator") or a group ("team"). "draw:" may stand before it. Throws
/// std::invalid_argument, one line with the nearest name, for a name that chooses nothing.
std::vector<std::string> chosenDrawings(const std::vector<std::string>& names);

/// A drawing's id as an argument of a template.
template <std::size_t size>
struct DrawingId {
  consteval DrawingId(const char (&id)[size]) {
    std::copy_n(id, size, text);
  }  // NOLINT: meant to be implicit
  char text[size]{};
};

namespace debugging {
/// Always true, so that a constant can call it.
bool noteDrawing(const char* id);

/// Its constant is made when the program starts, if any code names it: so a drawing is known before the code
/// first gets there.
template <DrawingId id>
struct NotedDrawing {
  static inline const bool noted = noteDrawing(id.text);
};
}  // namespace debugging
}  // namespace plumbline
