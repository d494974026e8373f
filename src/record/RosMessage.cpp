#include "record/RosMessage.h"

#include <array>
#include <cctype>
#include <map>
#include <set>
#include <vector>

namespace plumbline::record {
namespace {

constexpr std::array<const char*, 13> rosWords = {"bool",    "uint8",   "int8",   "int16",  "int32",
                                                  "int64",   "uint8",   "uint16", "uint32", "uint64",
                                                  "float32", "float64", "string"};

/// stepHeight, T_torso_link -> step_height, t_torso_link
std::string fieldName(const std::string& label) {
  const auto is = [&](std::size_t i, int (*kind)(int)) {
    return kind(static_cast<unsigned char>(label[i])) != 0;
  };
  std::string name;
  for (std::size_t i = 0; i < label.size(); ++i) {
    const bool wordBegins =
        i > 0 && is(i, std::isupper) && (is(i - 1, std::islower) || is(i - 1, std::isdigit));
    if ((wordBegins || label[i] == '_') && !name.empty() && name.back() != '_') name += '_';
    if (label[i] != '_') name += static_cast<char>(std::tolower(static_cast<unsigned char>(label[i])));
  }
  while (!name.empty() && name.back() == '_') name.pop_back();
  if (name.empty()) return "value";
  return std::isdigit(static_cast<unsigned char>(name.front())) ? "value_" + name : name;
}

std::string typeName(const std::string& label) {
  std::string name;
  bool upper = true;
  for (const char c : label) {
    if (c == '_') {
      upper = true;
      continue;
    }
    name += upper ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    upper = false;
  }
  return name;
}

class Definitions {
public:
  std::string all(const std::string& name, const Schema& schema) {
    std::string text = message(name, schema);
    for (std::size_t i = 0; i < others_.size(); ++i) {  // grows
      const auto [type, part] = others_[i];
      const std::string body = message(type, part);
      text += std::string(80, '=') + "\nMSG: " + messagePackage + "/" + type + '\n' + body;
    }
    return text;
  }

private:
  /// What is written before a field's name; `type`: the name that a message for it gets.
  std::string typeOf(const Schema& schema, const std::string& type) {
    if (schema.kind == Schema::Kind::raw) return "uint8[" + std::to_string(schema.size) + "]";
    if (schema.kind < Schema::Kind::object) return rosWords[static_cast<std::size_t>(schema.kind)];
    if (schema.kind == Schema::Kind::list) {
      const std::string element = typeOf(schema.parts.front(), type + "Element");
      // A list of lists has no name in ROS 2: a message around the inner one changes no byte.
      if (element.back() == ']') return other(type + "Element", schema.parts.front()) + "[]";
      return element + "[]";
    }
    if (schema.isArray()) {
      // An array of arrays lies in memory as one.
      std::size_t count = schema.parts.size();
      const Schema* element = &schema.parts.front();
      for (; element->isArray(); element = &element->parts.front()) count *= element->parts.size();
      const std::string inner = typeOf(*element, type + "Element");
      const std::string name = inner.back() == ']' ? other(type + "Element", *element) : inner;
      return name + '[' + std::to_string(count) + ']';
    }
    return other(type, schema);
  }

  std::string other(const std::string& wanted, const Schema& schema) {
    std::string name = wanted;
    for (int number = 2;; ++number) {
      const auto [entry, isNew] = known_.try_emplace(name, schema);
      if (isNew) {
        others_.emplace_back(name, schema);
        break;
      }
      if (entry->second == schema) break;
      name = wanted + std::to_string(number);
    }
    return std::string(messagePackage) + "/" + name;
  }

  std::string message(const std::string& name, const Schema& schema) {
    std::string text;
    std::set<std::string> taken;
    const auto field = [&](const Schema& part, const std::string& label) {
      std::string wanted = fieldName(label), fieldIs = wanted;
      for (int number = 2; !taken.insert(fieldIs).second; ++number) fieldIs = wanted + std::to_string(number);
      text += typeOf(part, name + typeName(label)) + ' ' + fieldIs + '\n';
    };
    if (schema.kind != Schema::Kind::object || schema.isArray()) {
      field(schema, "values");
    } else {
      for (const Schema& part : schema.parts) field(part, part.label.empty() ? "value" : part.label);
    }
    // An object without members is one byte on the wire.
    return text.empty() ? "uint8 structure_needs_at_least_one_member\n" : text;
  }

  std::map<std::string, Schema> known_;
  std::vector<std::pair<std::string, Schema>> others_;
};

}  // namespace

std::string messageType(const std::string& representation) {
  return std::string(messagePackage) + "/msg/" + representation;
}

std::string messageDefinition(const std::string& representation, const Schema& schema) {
  return Definitions().all(representation, schema);
}

}  // namespace plumbline::record
