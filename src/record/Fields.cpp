#include "record/Fields.h"

#include <array>
#include <charconv>
#include <limits>
#include <stdexcept>

#include "record/CdrStream.h"

namespace plumbline::record {
namespace {

class Walker {
public:
  Walker(std::string_view message, const FieldVisitor& visitor) : in_(message), visitor_(visitor) {}

  void walk(const Schema& schema) {
    const std::size_t length = path_.size();
    switch (schema.kind) {
      case Schema::Kind::object:
        for (std::size_t i = 0; i < schema.parts.size(); ++i) {
          const std::string& label = schema.parts[i].label;
          path_ += label.empty() ? '[' + std::to_string(i) + ']' : '.' + label;
          walk(schema.parts[i]);
          path_.resize(length);
        }
        return;
      case Schema::Kind::list:
        return walkList(schema.parts.front());
      default:
        return leaf(schema);
    }
  }
  void finish() {
    if (in_.ok() && !in_.atEnd()) in_.fail("bytes left over");
    if (!in_.ok()) throw std::runtime_error(in_.error());
  }

private:
  void walkList(const Schema& element) {
    const std::size_t length = path_.size();
    in_.beginList();
    // Elements are visited as they come; their number is known at the end.
    std::uint64_t count = 0;
    while (in_.nextElement()) {
      path_ += '[' + std::to_string(count++) + ']';
      walk(element);
      path_.resize(length);
    }
    in_.endList();
    if (in_.ok()) visitor_(path_ + ".length", count);
  }
  template <typename T>
  void write(T value) {
    if (in_.ok()) visitor_(path_, value);
  }
  void leaf(const Schema& schema) {
    using Kind = Schema::Kind;
    const auto offset = [&](Kind smallest) {
      return 1u << (static_cast<unsigned>(schema.kind) - static_cast<unsigned>(smallest));
    };
    if (schema.kind == Kind::boolean) {
      bool value = false;
      in_.readBool(value);
      write(value);
    } else if (schema.kind >= Kind::int8 && schema.kind <= Kind::int64) {
      std::int64_t value = 0;
      in_.readSigned(value, offset(Kind::int8));
      write(value);
    } else if (schema.kind >= Kind::uint8 && schema.kind <= Kind::uint64) {
      std::uint64_t value = 0;
      in_.readUnsigned(value, offset(Kind::uint8));
      write(value);
    } else if (schema.kind == Kind::float32) {
      float value = 0;
      in_.readFloat(value);
      write(value);
    } else if (schema.kind == Kind::float64) {
      double value = 0;
      in_.readDouble(value);
      write(value);
    } else {
      std::string value(schema.kind == Kind::text ? 0 : schema.kind == Kind::raw ? schema.size : 1, '\0');
      if (schema.kind == Kind::text)
        in_.readString(value);
      else
        in_.readRaw(value.data(), value.size());
      write(schema.kind == Kind::raw ? hexadecimal(value) : value);
    }
  }
  static std::string hexadecimal(const std::string& bytes) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text;
    for (const char c : bytes) {
      text += digits[static_cast<unsigned char>(c) >> 4];
      text += digits[static_cast<unsigned char>(c) & 15];
    }
    return text;
  }

  CdrInStream in_;
  const FieldVisitor& visitor_;
  std::string path_;
};

template <typename T>
std::string shortest(T value) {
  std::array<char, 40> buffer{};
  return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr};
}

}  // namespace

std::string fieldText(const FieldValue& value) {
  return std::visit(
      [](const auto& v) -> std::string {
        using T = std::decay_t<decltype(v)>;
        if constexpr (std::is_same_v<T, bool>) return v ? "true" : "false";
        if constexpr (std::is_same_v<T, std::string>) {
          return v;
        } else if constexpr (!std::is_same_v<T, bool>) {
          return shortest(v);
        }
        return {};
      },
      value);
}

double fieldNumber(const FieldValue& value) {
  return std::visit(
      [](const auto& v) -> double {
        if constexpr (std::is_same_v<std::decay_t<decltype(v)>, std::string>) {
          return std::numeric_limits<double>::quiet_NaN();
        } else {
          return static_cast<double>(v);
        }
      },
      value);
}

void visitFields(const Schema& schema, std::string_view message, const FieldVisitor& visitor) {
  if (schema.parts.empty() && schema.kind == Schema::Kind::object) return;  // nothing but a byte in its place
  Walker walker(message, visitor);
  walker.walk(schema);
  walker.finish();
}

}  // namespace plumbline::record
