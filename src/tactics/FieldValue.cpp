#include "tactics/FieldValue.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace plumbline {
namespace {

constexpr std::array<const char*, FieldGrid::advantages> tableNames = {"theirs", "nobodys", "ours"};
constexpr std::size_t maxPoints = 100;  ///< along an axis

std::vector<double> readAxis(const ConfigSection& file, const std::string& key) {
  auto values = file.get<std::vector<double>>(key, {-100, 100});
  if (values.size() < 2 || values.size() > maxPoints) file.fail(key, "must have 2 to 100 numbers");
  if (std::ranges::adjacent_find(values, std::greater_equal<>()) != values.end())
    file.fail(key, "must rise from number to number");
  return values;
}

FieldGrid readGrid(const ConfigSection& file) {
  std::vector<double> x = readAxis(file, "x"), y = readAxis(file, "y");
  for (std::size_t i = 0; i < x.size(); ++i)
    if (std::abs(x[i] + x[x.size() - 1 - i]) > 1e-9) file.fail("x", "must be symmetric about 0");
  if (y[0] != 0) file.fail("y", "must begin with 0: the other side is its mirror image");
  return FieldGrid(std::move(x), std::move(y));
}

std::string row(const std::vector<double>& values, const char* format) {
  std::string text;
  for (const double value : values)
    text += (text.empty() ? "" : ", ") + fmt::format(fmt::runtime(format), value);
  return "[" + text + "]";
}

}  // namespace

FieldValue::FieldValue(FieldGrid grid, std::vector<double> values)
    : grid_(std::move(grid)), values_(std::move(values)) {}

FieldValue::FieldValue(const ConfigSection& file) : grid_(readGrid(file)), values_(grid_.size()) {
  for (std::size_t ia = 0; ia < FieldGrid::advantages; ++ia) {
    const auto table = file.get<std::vector<std::vector<double>>>(tableNames[ia], {-1, 1});
    const bool fits = table.size() == grid_.y().size() &&
                      std::ranges::all_of(table, [&](const auto& r) { return r.size() == grid_.x().size(); });
    if (!fits)
      file.fail(tableNames[ia],
                fmt::format("must have {} rows, one for each y, of {} numbers, one for each x",
                            grid_.y().size(), grid_.x().size()));
    for (std::size_t iy = 0; iy < table.size(); ++iy)
      for (std::size_t ix = 0; ix < table[iy].size(); ++ix) values_[grid_.point(ix, iy, ia)] = table[iy][ix];
  }
}

double FieldValue::at(const BallState& state) const {
  double value = 0;
  for (const FieldGrid::Weight& weight : grid_.weights(state)) value += weight.weight * values_[weight.point];
  return value;
}

std::string FieldValue::yaml() const {
  std::string text = "x: " + row(grid_.x(), "{:g}") + "\ny: " + row(grid_.y(), "{:g}") + "\n";
  for (std::size_t ia = 0; ia < FieldGrid::advantages; ++ia) {
    text += std::string(tableNames[ia]) + ":\n";
    for (std::size_t iy = 0; iy < grid_.y().size(); ++iy) {
      std::vector<double> values;
      for (std::size_t ix = 0; ix < grid_.x().size(); ++ix)
        values.push_back(values_[grid_.point(ix, iy, ia)]);
      text += "  - " + row(values, "{:.3f}") + "\n";
    }
  }
  return text;
}

}  // namespace plumbline
