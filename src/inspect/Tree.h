#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::inspect {

/// A streamed value as a tree: a leaf holds its text form, a group its parts, which have labels in an object
/// and none in a list.
struct Tree {
  std::string label, text;
  bool group = false;
  std::vector<Tree> parts{};
};

/// Groups within each other; the text of a client may hold any number.
inline constexpr unsigned maxTreeDepth = 32;

/// Reads the text form (framework/TextStream.h). A leaf is a word, or is in quotes. Returns "" or the error
/// in one line.
std::string parseTree(std::string_view text, Tree& tree);
/// The text form in one line.
std::string treeText(const Tree& tree);
nlohmann::json treeJson(const Tree& tree);

/// The part of a tree at `path`: ".relative.x", ".joints[2]"; "" is the tree itself. If there is none: null,
/// and `error` in one line that names the existing parts.
Tree* findPart(Tree& tree, std::string_view path, std::string& error);

/// The paths one step below the tree: ".x", ".y" or "[0]", "[1]"; at most `most`.
std::vector<std::string> partPaths(const Tree& tree, std::size_t most);

}  // namespace plumbline::inspect
