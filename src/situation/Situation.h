#pragma once
#include <array>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "math/Pose2.h"
#include "representations/behavior/TeamPlaces.h"
#include "representations/infrastructure/GameState.h"
#include "representations/modeling/OtherRobots.h"
#include "robot/KickEffect.h"

namespace plumbline {

/// What a situation may hold at most.
struct SituationLimits {
  static constexpr double farthest = 100;  ///< of a place from the middle [m]
};

/// What decides in a situation.
enum class Decider { striker, goalie, formation, supporter, block, setPiece, passCall };
/// The words for them in files, in that order.
constexpr std::array<const char*, 7> deciderNames = {"striker", "goalie",   "formation", "supporter",
                                                     "block",   "setPiece", "passCall"};
/// Whether the play mode matters to it.
constexpr bool knowsMode(Decider decider) {
  return decider == Decider::formation || decider == Decider::setPiece || decider == Decider::passCall;
}

/// What a player of the team has said of itself.
struct SaidPlace {
  int number = 0;
  Pose2 pose;
  double timeToBall = 0;  ///< [s]
};

/// The striker plays the ball in a direction between two [rad], by a kick that carries so far [m].
struct StrikerExpected {
  enum class Action { any, kick, dribble };
  static constexpr std::array<const char*, 3> actionNames = {"any", "kick", "dribble"};  ///< in files
  Action action = Action::any;
  Vec2 direction = Vec2::Zero();
  std::optional<Vec2> reach{};
};

/// The goalie goes to a place [m].
struct GoalieExpected {
  Vec2 place = Vec2::Zero();
  double within = 0;
  std::optional<double> fromTheWay{};  ///< so near to the way of the ball
};

/// Who goes to the ball, and the role and the place of the player that is asked.
struct FormationExpected {
  enum class Role { goalie, striker, supporter };
  static constexpr std::array<const char*, 3> roleNames = {"goalie", "striker", "supporter"};  ///< in files
  int striker = 0;
  Role role = Role::supporter;
  std::optional<std::array<double, 4>> area{};  ///< x from, to, y from, to [m]
};

/// A supporter or the taker of a set piece uses a skill.
struct SkillExpected {
  std::string skill;             ///< see Skill
  std::optional<Vec2> target{};  ///< of the player, or of the ball if it is kicked [m]
  std::optional<double> heading{};
  double within = 0;  ///< [m, rad]
};

/// Which opponent is blocked, 0: none; and from where.
struct BlockExpected {
  int opponent = 0;
  Vec2 place = Vec2::Zero();
  double within = 0;
};

/// Whether the referee is asked for pass mode.
struct CallExpected {
  bool asks = false;
};

/// Nothing, or that of the situation's decider.
using Expected = std::variant<std::monostate, StrikerExpected, GoalieExpected, FormationExpected,
                              SkillExpected, BlockExpected, CallExpected>;

/// Where everybody is, in the frame of the own team [m, rad, m/s], and the decision that people expect. A
/// decider has only what its files may hold (doc/reference/situation-files.md).
struct Situation {
  std::string about{};  ///< what is so, and why it is decided as expected
  Decider decides = Decider::striker;
  TeamPlayMode mode = TeamPlayMode::playOn;
  int player = 0;                ///< number of the one whose decision it is; 0: not known
  Pose2 robot{};                 ///< that player; nobody of a block, which is the team's
  std::optional<Pose2> place{};  ///< where the team's plan sends it
  Vec2 ball = Vec2::Zero();
  Vec2 ballVelocity = Vec2::Zero();
  double ballAge = 0;  ///< since anybody saw it [s]
  std::vector<OtherRobot> others{};
  std::vector<PlacedPlayer> going{};  ///< where mates look and go
  std::vector<SaidPlace> team{};      ///< of all, the player among them
  std::vector<KickEffect> kicks{};
  std::optional<double> opponentKick{};  ///< how far they were seen to kick [m]
  Expected expected{};
};

}  // namespace plumbline
