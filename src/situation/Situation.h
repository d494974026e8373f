#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "math/Pose2.h"
#include "representations/behavior/TeamPlaces.h"
#include "representations/infrastructure/GameState.h"
#include "representations/modeling/OtherRobots.h"
#include "situation/ExpectedDecision.h"

namespace plumbline {

class SituationKind;

/// What a player of the team has said of itself.
struct SaidPlace {
  int number = 0;
  Pose2 pose;
  double timeToBall = 0;  ///< [s]
};

/// What only situations of one kind have, beyond the members of Situation. A kind's own struct derives from
/// it.
struct KindKnowledge {
  virtual ~KindKnowledge() = default;
};

/// Where everybody is, in the frame of the own team [m, rad, m/s], and the decision that people expect. It
/// has only what files of its kind may hold (doc/reference/situation-files.md).
struct Situation {
  std::string about{};                  ///< what is so, and why it is decided as expected
  const SituationKind* kind = nullptr;  ///< what decides; one that was read or taken from a log has it
  TeamPlayMode mode = TeamPlayMode::playOn;
  int player = 0;                ///< number of the one whose decision it is; 0: not known
  Pose2 robot{};                 ///< that player; nobody of a decision that is the team's
  std::optional<Pose2> place{};  ///< where the team's plan sends it
  Vec2 ball = Vec2::Zero();
  Vec2 ballVelocity = Vec2::Zero();
  std::vector<OtherRobot> others{};
  std::vector<PlacedPlayer> going{};                   ///< where mates look and go
  std::vector<SaidPlace> team{};                       ///< of all, the player among them
  std::shared_ptr<const KindKnowledge> known{};        ///< see knownTo
  std::shared_ptr<const ExpectedDecision> expected{};  ///< null: nothing is expected; see expectedOf
};

/// What only situations of a kind have, as knownTo<StrikerKnowledge>(situation).kicks; its defaults where the
/// situation has none.
template <typename Knowledge>
const Knowledge& knownTo(const Situation& situation) {
  static const Knowledge none;
  const auto* known = dynamic_cast<const Knowledge*>(situation.known.get());
  return known ? *known : none;
}

/// The expected decision as its kind has it, as expectedOf<GoalieExpected>(situation)->place; null: it has
/// none or another kind's.
template <typename Expected>
const Expected* expectedOf(const Situation& situation) {
  return dynamic_cast<const Expected*>(situation.expected.get());
}

/// The expected decision for people; empty: nothing is expected.
inline std::string expectedWords(const Situation& situation) {
  return situation.expected ? situation.expected->words(situation.player) : "";
}

}  // namespace plumbline
