#pragma once
#include <string>
#include <vector>

#include "framework/ConfigSection.h"
#include "math/Types.h"

namespace plumbline {

/// Where the players without the ball stand, by where the ball is: config/formation.yaml, which a coach
/// edits. Between the balls of the table places are interpolated (bilinear); for a ball on the right all is
/// mirrored, left and right change their names. Team's frame [m].
class FormationTable {
public:
  static constexpr double farthest = 100;  ///< that a ball or place may be from the field's middle [m]

  FormationTable() = default;
  /// Throws ConfigurationError with file, line and key.
  explicit FormationTable(const ConfigSection& file);

  /// In the order of importance: a team of n supporters takes the first n.
  int size() const { return static_cast<int>(places_.size()); }
  const std::string& name(int place) const { return places_[static_cast<std::size_t>(place)].name; }
  Vec2 at(int place, const Vec2& ball) const;

private:
  struct Place {
    std::string name;
    std::size_t mirror = 0;  ///< the place that is this one for a ball on the other side
  };
  using Table = std::vector<std::vector<double>>;  ///< a row for each ballY_, a column for each ballX_
  void checkTable(const ConfigSection& section, const std::string& key, const Table& table) const;
  void keep(const std::vector<Table>& x, const std::vector<Table>& y);
  const Vec2& corner(std::size_t row, std::size_t column, std::size_t place) const {
    return corners_[(row * ballX_.size() + column) * places_.size() + place];
  }
  void findMirrors(const ConfigSection& file);

  std::vector<double> ballX_, ballY_;
  std::vector<Place> places_;
  /// All places for a ball are together, because a player works out all of them in every cycle.
  std::vector<Vec2> corners_;
};

}  // namespace plumbline
