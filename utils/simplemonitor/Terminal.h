#pragma once
#include "watch/FieldPicture.h"

namespace plumbline::simplemonitor {

/// The terminal as ncurses has it; as before when this object ends. One at a time.
class Terminal {
public:
  /// asciiOnly: no other characters even where the locale has them. Throws std::runtime_error, one line, if
  /// standard output is no terminal or of a kind nobody knows.
  explicit Terminal(bool asciiOnly);
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  int columns() const;
  int rows() const;
  const watch::FieldPictureStyle& style() const { return style_; }
  void show(const watch::TextPicture& picture);

  enum class Key { none, quit, resized, redraw };
  /// What was pressed since the last call.
  Key key();

private:
  void* screen_ = nullptr;
  watch::FieldPictureStyle style_;
};

/// Whether the locale, which must have been set, writes UTF-8.
bool localeIsUnicode();

}  // namespace plumbline::simplemonitor
