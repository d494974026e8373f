#pragma once
#include "framework/Representation.h"
#include "math/Types.h"

namespace plumbline {

/// The field, from config/field.yaml [m].
REPRESENTATION(FieldDimensions)
class FieldDimensions : public FieldDimensionsBase {
public:
  double length = 30, width = 20;
  double goalWidth = 2.1, goalDepth = 0.6, goalHeight = 0.8;
  double penaltyDepth = 1.8, penaltyWidth = 6.0;
  double centreCircleRadius = 2.0;  ///< drawn as ten straight segments
  double ballRadius = 0.042;
  Vec2 opponentGoal() const { return {length / 2, 0}; }
  void stream(InStream* in, OutStream* out) override {
    STREAM(length);
    STREAM(width);
    STREAM(goalWidth);
    STREAM(goalDepth);
    STREAM(goalHeight);
    STREAM(penaltyDepth);
    STREAM(penaltyWidth);
    STREAM(centreCircleRadius);
    STREAM(ballRadius);
  }
};

}  // namespace plumbline
