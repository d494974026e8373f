#include "parameters/Parameter.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace plumbline {
namespace {

template <typename T>
constexpr bool isText = std::is_same_v<T, std::string>;

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

template <typename Values>
std::string listText(const Values& values) {
  std::string result = "[";
  for (const auto& value : values) {
    if (result.size() > 1) result += ", ";
    if constexpr (isText<std::decay_t<decltype(value)>>) {
      result += quoted(value);
    } else {
      result += shortestText(value);
    }
  }
  return result + "]";
}

/// Calls visitor(double) for every number in a value.
template <typename T, typename Visitor>
void visitNumbers(const T& value, Visitor&& visitor) {
  if constexpr (std::is_arithmetic_v<T> && !std::is_same_v<T, bool>) {
    visitor(static_cast<double>(value));
  } else if constexpr (std::is_same_v<T, std::vector<double>>) {
    for (const double number : value) visitor(number);
  }
}

}  // namespace

bool Parameter::has(const std::string& attribute) const {
  return std::find(attributes.begin(), attributes.end(), attribute) != attributes.end();
}

ParameterList::ParameterList() = default;
ParameterList::~ParameterList() = default;
ParameterList::ParameterList(const ParameterList&) = default;
ParameterList& ParameterList::operator=(const ParameterList&) = default;

bool ParameterList::add(Parameter parameter, Pointer pointer) {
  entries_.push_back({std::move(parameter), pointer, nullptr, nullptr});
  return true;
}

bool ParameterList::declare(const char* name, const char* unit, const Range& range, const char* comment,
                            std::initializer_list<const char*> attributes, const ParameterPointer& value,
                            Pointer pointer) {
  return add({name, unit, range, comment, {attributes.begin(), attributes.end()}, {}, parameterText(value)},
             pointer);
}

bool ParameterList::declareChoice(const char* name, const char* comment,
                                  std::initializer_list<const char*> words, const char* value,
                                  Pointer pointer) {
  return add({name, "", {}, comment, {}, {words.begin(), words.end()}, value}, pointer);
}

bool ParameterList::addGroup(std::string_view name, std::string_view comment, const ParameterList& group,
                             GroupPointer groupOf) {
  entries_.push_back(
      {{std::string(name), "", {}, std::string(comment), {}, {}, ""}, nullptr, &group, groupOf});
  return true;
}

std::vector<std::string> ParameterList::paths() const {
  std::vector<std::string> result;
  collectPaths("", result);
  return result;
}

void ParameterList::collectPaths(const std::string& prefix, std::vector<std::string>& paths) const {
  for (const Entry& entry : entries_) {
    const std::string path = prefix + entry.parameter.name;
    if (entry.group) {
      entry.group->collectPaths(path + ".", paths);
    } else {
      paths.push_back(path);
    }
  }
}

std::string parameterText(const ParameterPointer& value) {
  return std::visit(
      [](const auto* pointer) -> std::string {
        using T = std::decay_t<decltype(*pointer)>;
        if constexpr (std::is_same_v<T, bool>) {
          return *pointer ? "true" : "false";
        } else if constexpr (isText<T>) {
          return *pointer;
        } else if constexpr (std::is_integral_v<T>) {
          return std::to_string(*pointer);
        } else if constexpr (std::is_floating_point_v<T>) {
          return shortestText(*pointer);
        } else {
          return listText(*pointer);
        }
      },
      value);
}

std::string parameterType(const ParameterPointer& value) {
  return std::visit(
      [](const auto* pointer) -> std::string {
        using T = std::decay_t<decltype(*pointer)>;
        if constexpr (std::is_same_v<T, bool>) return "bool";
        if constexpr (isText<T>) return "text";
        if constexpr (std::is_same_v<T, unsigned>) return "unsigned int";
        if constexpr (std::is_integral_v<T>) return "int";
        if constexpr (std::is_floating_point_v<T>) return "double";
        if constexpr (std::is_same_v<T, std::vector<double>>) return "list of numbers";
        return "list of texts";
      },
      value);
}

ParameterValue parameterValue(const ParameterPointer& value) {
  return std::visit([](const auto* pointer) { return ParameterValue(*pointer); }, value);
}

void setParameterValue(const ParameterPointer& target, const ParameterValue& value) {
  std::visit([&](auto* pointer) { *pointer = std::get<std::decay_t<decltype(*pointer)>>(value); }, target);
}

std::string parameterFault(const Parameter& parameter, const ParameterPointer& value) {
  std::string fault;
  std::visit(
      [&](const auto* pointer) {
        visitNumbers(*pointer, [&](double number) {
          if (!fault.empty()) return;
          if (!std::isfinite(number)) {
            fault = "must be a finite number";
          } else if (!parameter.range.contains(number)) {
            fault = "must be " + boundsText(parameter.range) + ", not " + shortestText(number);
          }
        });
      },
      value);
  if (const auto* text = std::get_if<std::string*>(&value);
      text && fault.empty() && !parameter.words.empty()) {
    const auto& words = parameter.words;
    if (std::find(words.begin(), words.end(), **text) == words.end()) {
      for (std::size_t i = 0; i < words.size(); ++i)
        fault += (i == 0 ? "must be " : i + 1 < words.size() ? ", " : " or ") + words[i];
      fault += ", not \"" + **text + "\"";
    }
  }
  return fault;
}

}  // namespace plumbline
