#include "walking/parameters/WalkParameters.h"

#include <algorithm>
#include <stdexcept>
#include <type_traits>
#include <variant>

namespace plumbline::walking {
namespace {

// Every parameter is a double at a fixed place of WalkParameters.
static_assert(std::is_standard_layout_v<WalkParameters>);

std::vector<WalkParameter> collect() {
  std::vector<WalkParameter> result;
  WalkParameters sample;
  const auto* begin = reinterpret_cast<const std::byte*>(&sample);
  WalkParameters::parameterList().visit(
      &sample, [&](const std::string& path, const Parameter& declared, const ParameterPointer& pointer) {
        const auto* place = reinterpret_cast<const std::byte*>(std::get<double*>(pointer));
        result.push_back({path, &declared, static_cast<std::size_t>(place - begin), declared.has("blends")});
      });
  return result;
}

[[noreturn]] void refuse(const std::string& path, const std::string& fault) {
  throw std::invalid_argument("walking parameter " + path + " " + fault);
}

void demand(const std::string& path, const Parameter& declared, double value) {
  if (const std::string fault = parameterFault(declared, &value); !fault.empty()) refuse(path, fault);
}

}  // namespace

double& WalkParameter::of(WalkParameters& p) const {
  return *reinterpret_cast<double*>(reinterpret_cast<std::byte*>(&p) + offset);
}

double WalkParameter::of(const WalkParameters& p) const {
  return *reinterpret_cast<const double*>(reinterpret_cast<const std::byte*>(&p) + offset);
}

const std::vector<WalkParameter>& walkParameters() {
  static const std::vector<WalkParameter> all = collect();
  return all;
}

const WalkParameter* findWalkParameter(const std::string& path) {
  const auto& all = walkParameters();
  const auto found = std::ranges::find(all, path, &WalkParameter::path);
  return found == all.end() ? nullptr : &*found;
}

const WalkParameter& walkParameter(const std::string& path) {
  if (const WalkParameter* found = findWalkParameter(path)) return *found;
  throw std::invalid_argument("no walking parameter " + path);
}

void WalkParameters::check() const {
  for (const WalkParameter& one : walkParameters()) demand(one.path, *one.declared, one.of(*this));
  const auto demandOf = [](const std::string& path, Range range, double value) {
    demand(path, {"", "", range, "", {}, {}, ""}, value);
  };
  demandOf("step.minDuration", {0, step.duration}, step.minDuration);
  demandOf("step.maxDuration", {step.duration, 10}, step.maxDuration);
}

}  // namespace plumbline::walking
