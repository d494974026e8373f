#pragma once
#include <string>

#include "situation/Situation.h"

namespace plumbline {

/// Whether the referee is asked for pass mode.
class CallExpected : public ExpectedDecision {
public:
  std::string text() const override;
  std::string words(int player) const override;
  void draw(const Situation& situation, const FieldSize& field, SituationCanvas& canvas) const override;

  bool asks = false;
};

}  // namespace plumbline
