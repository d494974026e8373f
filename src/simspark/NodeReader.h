#pragma once
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

#include "math/Types.h"
#include "simspark/SExpression.h"
#include "simspark/ServerMessageParser.h"

namespace plumbline::simspark {

/// Reads words and fields of a message's nodes, and remembers the first that is not as it must be. After
/// that, numbers are 0 and words empty.
class NodeReader {
public:
  using Node = SExpressions::Node;

  /// text: that the nodes are from; for the places of errors.
  explicit NodeReader(std::string_view text) : text_(text) {}

  bool failed() const { return error_.has_value(); }
  const std::optional<ParseError>& error() const { return error_; }
  /// An error at a word of the text, unless there was one before.
  void fail(std::string_view at, std::string what);

  double number(std::string_view word);
  int integer(std::string_view word);

  /// The words behind the node's name, which are so many.
  template <std::size_t count>
  std::array<std::string_view, count> words(Node node) {
    std::array<std::string_view, count> found;
    if (collect(node, found.data(), count) != count) failCount(node, count);
    return failed() ? std::array<std::string_view, count>() : found;
  }
  std::string_view word(Node node) { return words<1>(node)[0]; }
  /// (name x y z), as in the text.
  Vec3 vector(Node node);

  /// Calls field(list, name) for each list in a node until one fails. A loose word there is an error.
  template <typename Field>
  void eachField(Node node, Field&& field) {
    for (Node child = node.first().next(); child && !failed(); child = child.next()) {
      if (!child.isList()) return failWord(child, node);
      field(child, child.name());
    }
  }

private:
  /// How many words there are; more than room or a list among them count as room + 1.
  static std::size_t collect(Node node, std::string_view* found, std::size_t room);
  void failCount(Node node, std::size_t count);
  void failWord(Node word, Node node);

  std::string_view text_;
  std::optional<ParseError> error_;
};

}  // namespace plumbline::simspark
