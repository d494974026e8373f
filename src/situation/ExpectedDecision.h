#pragma once
#include <string>
#include <vector>

#include "field/FieldSize.h"
#include "math/Pose2.h"

namespace plumbline {

struct Situation;
class SituationCanvas;

/// The decision that people expect in a situation. Each kind of situation has its own class of it, which
/// tests compare with what was decided.
class ExpectedDecision {
public:
  virtual ~ExpectedDecision() = default;

  /// The part `expected` of a situation's file as a line of YAML.
  virtual std::string text() const = 0;
  /// The same for people: "kicks between 5 and 52 degrees left". `player`: whose decision it is.
  virtual std::string words(int player) const = 0;
  /// Places that its picture has to show in addition to everybody's.
  virtual std::vector<Vec2> places(const Situation& /*situation*/, const FieldSize& /*field*/) const {
    return {};
  }
  /// Its marks in the picture, below the players.
  virtual void draw(const Situation& situation, const FieldSize& field, SituationCanvas& canvas) const = 0;
};

}  // namespace plumbline
