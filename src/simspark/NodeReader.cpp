#include "simspark/NodeReader.h"

#include "simspark/NumberFormat.h"

namespace plumbline::simspark {

namespace {

/// For an error's text, with an end.
std::string quoted(std::string_view word) { return "'" + std::string(word.substr(0, 20)) + "'"; }

}  // namespace

void NodeReader::fail(std::string_view at, std::string what) {
  if (!error_) error_ = ParseError{static_cast<std::size_t>(at.data() - text_.data()), std::move(what)};
}

double NodeReader::number(std::string_view word) {
  if (failed()) return 0;
  const auto value = parseNumber(word);
  if (!value) fail(word, quoted(word) + " is no number");
  return value.value_or(0);
}

int NodeReader::integer(std::string_view word) {
  if (failed()) return 0;
  const auto value = parseInteger(word);
  if (!value) fail(word, quoted(word) + " is no whole number");
  return value.value_or(0);
}

Vec3 NodeReader::vector(Node node) {
  const auto [x, y, z] = words<3>(node);
  return {number(x), number(y), number(z)};
}

std::size_t NodeReader::collect(Node node, std::string_view* found, std::size_t room) {
  std::size_t count = 0;
  for (Node child = node.first().next(); child; child = child.next()) {
    if (child.isList() || count == room) return room + 1;
    found[count++] = child.text();
  }
  return count;
}

void NodeReader::failCount(Node node, std::size_t count) {
  fail(node.name(), quoted(node.name()) + " has not " + std::to_string(count) +
                        (count == 1 ? " word behind it" : " words behind it"));
}

void NodeReader::failWord(Node word, Node node) {
  fail(word.text(), quoted(word.text()) + " is no list, as fields of " + quoted(node.name()) + " are");
}

}  // namespace plumbline::simspark
