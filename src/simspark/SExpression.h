#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::simspark {

/// The s-expressions of one text: a list of trees, kept flat. Nodes refer to the text, which must outlive
/// them.
class SExpressions {
  static constexpr int atom = -2;
  struct Data {
    std::string_view text;
    int child = -1;  ///< first child; -1: an empty list; atom: no list
    int sibling = -1;
  };

public:
  struct Limits {
    std::size_t depth = 64;       ///< of nested lists
    std::size_t nodes = 1 << 20;  ///< atoms and lists
  };

  /// One atom or list; children and siblings are walked with children(), next().
  class Node {
  public:
    bool isList() const { return self().child != atom; }
    /// The text of an atom; empty for a list.
    std::string_view text() const { return self().text; }
    /// The atom a list begins with, "" if there is none: its name.
    std::string_view name() const;
    /// First child of a list, invalid if it is empty.
    Node first() const { return Node(owner_, self().child); }
    Node next() const { return Node(owner_, self().sibling); }
    explicit operator bool() const { return index_ >= 0; }
    /// The child list of that name, or invalid. An invalid node or an atom has no children.
    Node list(std::string_view listName) const;
    /// The n-th child (0: the name), or invalid.
    Node at(int n) const;

  private:
    friend class SExpressions;
    Node(const SExpressions* owner, int index) : owner_(owner), index_(index) {}
    const Data& self() const { return owner_->nodes_[static_cast<std::size_t>(index_)]; }
    const SExpressions* owner_;
    int index_;
  };

  SExpressions() = default;
  explicit SExpressions(Limits limits) : limits_(limits) {}

  /// False if the text is no list of s-expressions or exceeds a limit: error() and errorPosition() say more,
  /// and what was whole before the error is kept.
  bool parse(std::string_view text);
  const std::string& error() const { return message_; }
  std::size_t errorPosition() const { return position_; }

  /// First tree of the text, invalid if there is none.
  Node first() const;

private:
  bool fail(std::size_t at, const char* what);
  Limits limits_;
  std::vector<Data> nodes_;
  std::vector<int> open_;  ///< lists around the current place
  std::vector<int> last_;  ///< last child of each of them so far
  std::string message_;
  std::size_t position_ = 0;
};

}  // namespace plumbline::simspark
