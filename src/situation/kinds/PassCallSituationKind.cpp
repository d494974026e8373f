#include "situation/kinds/PassCallSituationKind.h"

#include <fmt/format.h>

#include "situation/SituationCanvas.h"
#include "situation/SituationKinds.h"

namespace plumbline {
namespace {

class PassCallSituationKind : public SituationKind {
public:
  PassCallSituationKind()
      : SituationKind({.name = "passCall",
                       .order = 70,
                       .heading = "Pass mode: whether the referee is asked for it",
                       .knowsMode = true}) {}

  std::shared_ptr<const ExpectedDecision> readExpected(const ConfigSection& section) const override {
    auto expected = std::make_shared<CallExpected>();
    expected->asks = section.get<bool>("asks");
    return expected;
  }
};

MAKE_SITUATION_KIND(PassCallSituationKind)

}  // namespace

std::string CallExpected::text() const { return fmt::format("{{asks: {}}}", asks); }

std::string CallExpected::words(int /*player*/) const {
  return asks ? "asks for pass mode" : "does not ask for pass mode";
}

void CallExpected::draw(const Situation& situation, const FieldSize&, SituationCanvas& canvas) const {
  canvas.label(situation.ball, asks ? "asks for pass mode" : "does not ask");
}

}  // namespace plumbline
