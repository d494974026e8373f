#include "modules/behavior/formation/FormationTable.h"

#include <algorithm>
#include <cmath>

#include "math/TablePlace.h"

namespace plumbline {
namespace {

constexpr std::size_t maxBalls = 50, maxPlaces = 10;

void checkRising(const ConfigSection& file, const std::string& key, const std::vector<double>& values) {
  if (values.size() < 2 || values.size() > maxBalls) file.fail(key, "must have 2 to 50 numbers");
  if (std::ranges::adjacent_find(values, std::greater_equal<>()) != values.end())
    file.fail(key, "must rise from number to number");
}

std::string otherSide(std::string name) {
  const auto change = [&name](const std::string& from, const std::string& to) {
    if (!name.starts_with(from)) return false;
    name.replace(0, from.size(), to);
    return true;
  };
  if (!change("left", "right")) change("right", "left");
  return name;
}

}  // namespace

FormationTable::FormationTable(const ConfigSection& file) {
  ballX_ = file.get<std::vector<double>>("ballX", {-farthest, farthest});
  ballY_ = file.get<std::vector<double>>("ballY", {0, farthest});
  checkRising(file, "ballX", ballX_);
  checkRising(file, "ballY", ballY_);
  if (ballY_[0] != 0) file.fail("ballY", "must begin with 0: the other side is its mirror image");
  std::vector<Table> x, y;  // of each place
  for (const ConfigSection& section : file.list("places")) {
    places_.push_back({.name = section.get<std::string>("name")});
    x.push_back(section.get<Table>("x", {-farthest, farthest}));
    y.push_back(section.get<Table>("y", {-farthest, farthest}));
    checkTable(section, "x", x.back());
    checkTable(section, "y", y.back());
  }
  if (places_.empty() || places_.size() > maxPlaces) file.fail("places", "must be 1 to 10");
  findMirrors(file);
  keep(x, y);
}

void FormationTable::keep(const std::vector<Table>& x, const std::vector<Table>& y) {
  for (std::size_t j = 0; j < ballY_.size(); ++j)
    for (std::size_t i = 0; i < ballX_.size(); ++i)
      for (std::size_t place = 0; place < places_.size(); ++place)
        corners_.emplace_back(x[place][j][i], y[place][j][i]);
}

void FormationTable::checkTable(const ConfigSection& section, const std::string& key,
                                const Table& table) const {
  const bool fits = table.size() == ballY_.size() &&
                    std::ranges::all_of(table, [&](const auto& row) { return row.size() == ballX_.size(); });
  if (!fits)
    section.fail(key, "must have a row for each of the " + std::to_string(ballY_.size()) +
                          " values of ballY, with a number for each of the " + std::to_string(ballX_.size()) +
                          " values of ballX");
}

void FormationTable::findMirrors(const ConfigSection& file) {
  for (Place& place : places_) {
    const std::string wanted = otherSide(place.name);
    const auto it = std::ranges::find(places_, wanted, &Place::name);
    if (it == places_.end())
      file.fail("places", "must have " + wanted + ", the mirror image of " + place.name);
    place.mirror = static_cast<std::size_t>(it - places_.begin());
  }
}

Vec2 FormationTable::at(int place, const Vec2& ball) const {
  const auto own = static_cast<std::size_t>(place);
  const bool mirrored = ball.y() < 0;
  const std::size_t from = mirrored ? places_[own].mirror : own;
  const auto [i, shareX] = placeInTable(ballX_, ball.x());
  const auto [j, shareY] = placeInTable(ballY_, std::abs(ball.y()));
  const Vec2 &a = corner(j, i, from), &b = corner(j, i + 1, from), &c = corner(j + 1, i, from),
             &d = corner(j + 1, i + 1, from);
  const auto mean = [&, shareX = shareX, shareY = shareY](int axis) {
    return std::lerp(std::lerp(a[axis], b[axis], shareX), std::lerp(c[axis], d[axis], shareX), shareY);
  };
  const double y = mean(1);
  return {mean(0), mirrored ? -y : y};
}

}  // namespace plumbline
