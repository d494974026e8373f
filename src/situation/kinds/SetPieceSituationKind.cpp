#include "situation/SituationKinds.h"
#include "situation/kinds/SkillExpected.h"

namespace plumbline {
namespace {

class SetPieceSituationKind : public SituationKind {
public:
  SetPieceSituationKind()
      : SituationKind({.name = "setPiece",
                       .order = 60,
                       .heading = "Set pieces: where the ball or the player goes",
                       .knowsMode = true}) {}

  std::shared_ptr<const ExpectedDecision> readExpected(const ConfigSection& section) const override {
    return SkillExpected::read(section, false);
  }
};

MAKE_SITUATION_KIND(SetPieceSituationKind)

}  // namespace
}  // namespace plumbline
