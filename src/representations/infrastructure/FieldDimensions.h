#pragma once
#include "field/FieldSize.h"
#include "framework/Representation.h"
#include "math/Types.h"

namespace plumbline {

/// The field, from config/field.yaml or the file that the command line names [m].
REPRESENTATION(FieldDimensions)
class FieldDimensions : public FieldDimensionsBase, public FieldSize {
public:
  const FieldSize& size() const { return *this; }
  Vec2 opponentGoal() const { return {length / 2, 0}; }
  void stream(InStream* in, OutStream* out) override {
    STREAM(length);
    STREAM(width);
    STREAM(goalWidth);
    STREAM(goalDepth);
    STREAM(goalHeight);
    STREAM(goalBarDiameter);
    STREAM(penaltyDepth);
    STREAM(penaltyWidth);
    STREAM(centreCircleRadius);
    STREAM(ballRadius);
  }
};

}  // namespace plumbline
