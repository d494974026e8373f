#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <variant>

#include "record/Schema.h"

namespace plumbline::record {

/// A single value of a message; a block of memory comes as its bytes.
using FieldValue = std::variant<bool, std::int64_t, std::uint64_t, double, float, std::string>;

/// Numbers with all their digits, texts as they are, blocks of memory in hexadecimal.
std::string fieldText(const FieldValue& value);
/// A number or truth value; NaN for a text.
double fieldNumber(const FieldValue& value);

/// Calls visitor(path, value) for each value of a message: `.relative.x`, `.angles[3]`; after the elements
/// of a list comes their number, `.names.length`. Throws std::runtime_error if the message does not have this
/// form.
using FieldVisitor = std::function<void(const std::string& path, const FieldValue& value)>;
void visitFields(const Schema& schema, std::string_view message, const FieldVisitor& visitor);

}  // namespace plumbline::record
