#include "trials/TaskOptions.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "framework/ConfigurationError.h"
#include "framework/NearestName.h"

namespace plumbline {
namespace {

template <typename Number>
void setNumber(const std::string& key, const std::string& text, const Range& range, Number& target) {
  Number value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !range.contains(static_cast<double>(value)))
    throw ConfigurationError(fmt::format("option {}: \"{}\" is no {} from {:g} to {:g}", key, text,
                                         std::is_integral_v<Number> ? "whole number" : "number", range.min,
                                         range.max));
  target = value;
}

void setOption(const std::string& key, const std::string& text, const Parameter& declared,
               const ParameterPointer& target) {
  if (auto* const* const number = std::get_if<double*>(&target))
    return setNumber(key, text, declared.range, **number);
  if (auto* const* const number = std::get_if<int*>(&target))
    return setNumber(key, text, declared.range, **number);
  *std::get<std::string*>(target) = text;
  if (!declared.words.empty() && std::ranges::count(declared.words, text) == 0)
    throw ConfigurationError(
        fmt::format("option {}: \"{}\" is not one of {}", key, text, fmt::join(declared.words, ", ")));
}

}  // namespace

std::string optionName(const std::string& path) {
  const std::size_t dot = path.rfind('.');
  return dot == std::string::npos ? path : path.substr(dot + 1);
}

std::vector<std::string> changedOptions(const ParameterList& declared, void* owner) {
  std::vector<std::string> names;
  declared.visit(owner,
                 [&](const std::string& path, const Parameter& parameter, const ParameterPointer& value) {
                   if (parameterText(value) != parameter.defaultText) names.push_back(optionName(path));
                 });
  return names;
}

std::vector<std::string> TaskOptions::lines() const {
  std::vector<std::string> lines;
  for (const auto& [key, value] : values_) lines.push_back(key + '=' + value);
  return lines;
}

TaskOptions TaskOptions::ofLines(const std::vector<std::string>& lines) {
  std::map<std::string, std::string> values;
  for (const std::string& line : lines) {
    const std::size_t equals = line.find('=');
    values[line.substr(0, equals)] = equals == std::string::npos ? "" : line.substr(equals + 1);
  }
  return TaskOptions(std::move(values));
}

int TaskOptions::robotType() const {
  int type = 0;
  if (const auto found = values_.find("type"); found != values_.end())
    std::from_chars(found->second.data(), found->second.data() + found->second.size(), type);
  return type;
}

void TaskOptions::read(const ParameterList& declared, void* owner) const {
  std::vector<std::string> known;
  declared.visit(owner,
                 [&](const std::string& path, const Parameter& parameter, const ParameterPointer& target) {
                   known.push_back(optionName(path));
                   if (const auto found = values_.find(known.back()); found != values_.end())
                     setOption(found->first, found->second, parameter, target);
                 });
  for (const auto& [key, value] : values_)
    if (std::ranges::count(known, key) == 0)
      throw ConfigurationError("unknown option \"" + key + '"' + suggestion(key, known));
}

}  // namespace plumbline
