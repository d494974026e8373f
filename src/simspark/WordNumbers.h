#pragma once
#include <optional>
#include <string_view>

#include "simspark/NumberFormat.h"
#include "simspark/SExpression.h"

namespace plumbline::simspark {

/// The text of a node that is a word; empty for a list and for no node.
inline std::string_view wordOf(SExpressions::Node node) {
  return node && !node.isList() ? node.text() : std::string_view();
}

/// The number that a word is; nothing for a list, no node or another text.
inline std::optional<double> numberOf(SExpressions::Node node) { return parseNumber(wordOf(node)); }
inline std::optional<int> integerOf(SExpressions::Node node) { return parseInteger(wordOf(node)); }

}  // namespace plumbline::simspark
