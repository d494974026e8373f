#include "simspark/SExpression.h"

namespace plumbline::simspark {

namespace {
constexpr bool isSpace(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\0'; }
constexpr bool endsAtom(char c) { return c == '(' || c == ')' || isSpace(c); }
}  // namespace

bool SExpressions::fail(std::size_t at, const char* what) {
  message = what;
  position = at;
  if (open.size() > 1) {  // the tree under way goes: half a command must not be taken for a whole one
    const int begun = open[1];
    for (int i = 0; i >= 0 && i < begun;) {
      int& sibling = nodes[static_cast<std::size_t>(i)].sibling;
      if (sibling == begun) sibling = -1;
      i = sibling;
    }
    nodes.resize(static_cast<std::size_t>(begun));
  }
  return false;
}

bool SExpressions::parse(std::string_view text) {
  nodes.clear();
  open.assign(1, -1);
  last.assign(1, -1);
  message.clear();
  position = 0;

  const auto append = [this](std::string_view atomText, int child) {
    const int index = static_cast<int>(nodes.size());
    nodes.push_back({atomText, child, -1});
    if (last.back() >= 0)
      nodes[static_cast<std::size_t>(last.back())].sibling = index;
    else if (open.back() >= 0)
      nodes[static_cast<std::size_t>(open.back())].child = index;
    last.back() = index;
    return index;
  };

  for (std::size_t i = 0; i < text.size();) {
    if (isSpace(text[i])) {
      ++i;
      continue;
    }
    if (text[i] == ')') {
      if (open.size() == 1) return fail(i, "a closing parenthesis without an opening one");
      open.pop_back();
      last.pop_back();
      ++i;
      continue;
    }
    if (nodes.size() >= limits.nodes) return fail(i, "too many elements");
    if (text[i] == '(') {
      if (open.size() > limits.depth) return fail(i, "nested too deeply");
      open.push_back(append({}, -1));
      last.push_back(-1);
      ++i;
      continue;
    }
    const std::size_t begin = i;
    while (i < text.size() && !endsAtom(text[i])) ++i;
    append(text.substr(begin, i - begin), atom);
  }
  if (open.size() > 1) return fail(text.size(), "a parenthesis is not closed");
  return true;
}

SExpressions::Node SExpressions::first() const { return Node(this, nodes.empty() ? -1 : 0); }

std::string_view SExpressions::Node::name() const {
  if (!isList()) return {};
  const Node child = first();
  return child && !child.isList() ? child.text() : std::string_view();
}

SExpressions::Node SExpressions::Node::list(std::string_view listName) const {
  if (!*this || !isList()) return Node(owner, -1);
  Node child = first();
  while (child && child.name() != listName) child = child.next();
  return child;
}

SExpressions::Node SExpressions::Node::at(int n) const {
  Node child = *this && isList() ? first() : Node(owner, -1);
  while (child && n-- > 0) child = child.next();
  return child;
}

}  // namespace plumbline::simspark
