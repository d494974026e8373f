#pragma once
#include <array>
#include <string>
#include <vector>

#include "field/TeamSize.h"
#include "framework/ConfigSection.h"
#include "math/Pose2.h"

namespace plumbline {

/// What a situation may hold at most.
struct SituationLimits {
  static constexpr double farthest = 100;  ///< of a place from the middle [m]
  static constexpr double longest = 1000;  ///< [s]
  static Range places() { return {-farthest, farthest}; }
  static Range distances() { return {0, farthest}; }
  static Range times() { return {0, longest}; }
  static Range numbers() { return {0, teamSize}; }  ///< of players, and 0
};

// Values of situation files that several kinds have. Reading throws as readSituation does.

/// [x, y, heading]
Pose2 readPose(const ConfigSection& section, const char* key);
std::string poseText(const Pose2& pose);

/// A row's number that is a player's, or 0.
int playerNumber(const ConfigSection& section, const char* key, double number);

/// Rows of numbers, each of a length within the bounds, no more than a team has players; none if the key is
/// missing. `form` says how a row looks.
std::vector<std::vector<double>> readRows(const ConfigSection& section, const char* key, std::size_t least,
                                          std::size_t most, const char* form);

/// The value of an enumeration whose words in files have this order.
template <typename Choice, std::size_t n>
Choice readChoice(const ConfigSection& section, const char* key, const std::array<const char*, n>& words) {
  return static_cast<Choice>(section.choice(key, {words.begin(), words.end()}));
}

/// A place for people: "(1.5, -2)".
std::string placeWords(const Vec2& place);

}  // namespace plumbline
