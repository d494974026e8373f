#include "simspark/SExpression.h"

namespace plumbline::simspark {

namespace {
constexpr bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\0'; }
constexpr bool endsAtom(char c) { return c == '(' || c == ')' || isSpace(c); }
}  // namespace

bool SExpressions::fail(std::size_t at, const char* what) {
  message_ = what;
  position_ = at;
  if (open_.size() > 1) {  // the tree under way goes: half a command must not be taken for a whole one
    const int begun = open_[1];
    for (int i = 0; i >= 0 && i < begun;) {
      int& sibling = nodes_[static_cast<std::size_t>(i)].sibling;
      if (sibling == begun) sibling = -1;
      i = sibling;
    }
    nodes_.resize(static_cast<std::size_t>(begun));
  }
  return false;
}

bool SExpressions::parse(std::string_view text) {
  nodes_.clear();
  open_.assign(1, -1);
  last_.assign(1, -1);
  message_.clear();
  position_ = 0;

  const auto append = [this](std::string_view atomText, int child) {
    const int index = static_cast<int>(nodes_.size());
    nodes_.push_back({atomText, child, -1});
    if (last_.back() >= 0)
      nodes_[static_cast<std::size_t>(last_.back())].sibling = index;
    else if (open_.back() >= 0)
      nodes_[static_cast<std::size_t>(open_.back())].child = index;
    last_.back() = index;
    return index;
  };

  for (std::size_t i = 0; i < text.size();) {
    if (isSpace(text[i])) {
      ++i;
      continue;
    }
    if (text[i] == ')') {
      if (open_.size() == 1) return fail(i, "a closing parenthesis without an opening one");
      open_.pop_back();
      last_.pop_back();
      ++i;
      continue;
    }
    if (nodes_.size() >= limits_.nodes) return fail(i, "too many elements");
    if (text[i] == '(') {
      if (open_.size() > limits_.depth) return fail(i, "nested too deeply");
      open_.push_back(append({}, -1));
      last_.push_back(-1);
      ++i;
      continue;
    }
    const std::size_t begin = i;
    while (i < text.size() && !endsAtom(text[i])) ++i;
    append(text.substr(begin, i - begin), atom);
  }
  if (open_.size() > 1) return fail(text.size(), "a parenthesis is not closed");
  return true;
}

SExpressions::Node SExpressions::first() const { return Node(this, nodes_.empty() ? -1 : 0); }

std::string_view SExpressions::Node::name() const {
  if (!isList()) return {};
  const Node child = first();
  return child && !child.isList() ? child.text() : std::string_view();
}

SExpressions::Node SExpressions::Node::list(std::string_view listName) const {
  if (!*this || !isList()) return Node(owner_, -1);
  Node child = first();
  while (child && child.name() != listName) child = child.next();
  return child;
}

SExpressions::Node SExpressions::Node::at(int n) const {
  Node child = *this && isList() ? first() : Node(owner_, -1);
  while (child && n-- > 0) child = child.next();
  return child;
}

}  // namespace plumbline::simspark
