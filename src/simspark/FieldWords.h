#pragma once
#include <array>

#include "field/FieldSize.h"

namespace plumbline::simspark {

/// The monitor protocol's word for a size of the field.
struct FieldWord {
  const char* name;
  double FieldSize::*size;
};

/// Words of the league's server.
constexpr std::array<FieldWord, 6> leagueFieldWords = {{{"FieldLength", &FieldSize::length},
                                                        {"FieldWidth", &FieldSize::width},
                                                        {"GoalWidth", &FieldSize::goalWidth},
                                                        {"GoalDepth", &FieldSize::goalDepth},
                                                        {"GoalHeight", &FieldSize::goalHeight},
                                                        {"BallRadius", &FieldSize::ballRadius}}};

/// Words of this project's simulator for what the league's server does not send; sent only for a field that
/// differs from the league's.
constexpr std::array<FieldWord, 4> ownFieldWords = {{{"PenaltyDepth", &FieldSize::penaltyDepth},
                                                     {"PenaltyWidth", &FieldSize::penaltyWidth},
                                                     {"CentreCircleRadius", &FieldSize::centreCircleRadius},
                                                     {"GoalBarDiameter", &FieldSize::goalBarDiameter}}};

}  // namespace plumbline::simspark
