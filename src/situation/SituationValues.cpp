#include "situation/SituationValues.h"

#include <fmt/format.h>

#include <cmath>

#include "situation/Rounded.h"

namespace plumbline {

Pose2 readPose(const ConfigSection& section, const char* key) {
  const Vec3 pose = section.get<Vec3>(key, SituationLimits::places());
  return {pose.x(), pose.y(), pose.z()};
}

std::string poseText(const Pose2& pose) {
  return "[" + rounded(pose.position) + ", " + rounded(pose.heading) + "]";
}

int playerNumber(const ConfigSection& section, const char* key, double number) {
  if (number != std::floor(number) || number < 0 || number > teamSize)
    section.fail(key, fmt::format("has {:g} where a player's number from 0 (not known) to {} must be", number,
                                  teamSize));
  return static_cast<int>(number);
}

std::vector<std::vector<double>> readRows(const ConfigSection& section, const char* key, std::size_t least,
                                          std::size_t most, const char* form) {
  using Rows = std::vector<std::vector<double>>;
  Rows rows = section.find<Rows>(key, SituationLimits::places()).value_or(Rows());
  if (rows.size() > teamSize)
    section.fail(key, fmt::format("must have {} at most, not {}", teamSize, rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (rows[i].size() < least || rows[i].size() > most)
      section.fail(key, fmt::format("must be a list of {}; number {} of it has {} values", form, i + 1,
                                    rows[i].size()));
  return rows;
}

std::string placeWords(const Vec2& place) { return "(" + rounded(place) + ")"; }

}  // namespace plumbline
