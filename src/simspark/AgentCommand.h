#pragma once
#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "math/Pose2.h"
#include "robot/JointId.h"
#include "simspark/SExpression.h"

namespace plumbline::simspark {

/// Asks for a robot: the scene file names its kind, the number its type, as simsparkRobots.
struct SceneRequest {
  std::string file = "rsg/agent/nao/nao_hetero.rsg";
  int type = 0;
};

/// Asks for a place in a team; unum 0: the next free one.
struct InitRequest {
  int unum = 0;
  std::string team;
};

/// What an agent sends in one message, in this project's signs and units.
struct AgentCommand {
  std::optional<SceneRequest> scene;
  std::optional<InitRequest> init;
  /// Where to stand [m, rad], seen by the own team: own goal at x = -15.
  std::optional<Pose2> beam;
  /// Hinge speeds [rad/s]; a joint not named keeps the speed it has.
  std::array<std::optional<double>, numHumanoidJoints> velocity;
  std::optional<std::string> say;  ///< at most 20 characters
  bool pass = false;               ///< asks for pass mode
  bool syn = false;                ///< in sync mode: done for this cycle
};

/// The message of a command, without frame.
std::string writeAgentCommand(const AgentCommand& command);
/// The same, appended.
void appendAgentCommand(std::string& out, const AgentCommand& command);

/// Reads agents' messages; one object per connection saves allocations.
class AgentCommandParser {
public:
  /// Whatever is understood is in command. The return value is empty, or one line about the first part that
  /// is not: such a part is skipped, as the league's server does, so that a newer agent can still play.
  std::string parse(std::string_view text, AgentCommand& command);

  /// Whether the last text was a list of s-expressions at all.
  bool wellFormed() const { return wellFormed_; }

private:
  bool wellFormed_ = true;
  SExpressions expressions_{{.depth = 8, .nodes = 4096}};
};

/// What a team may be called: 1 to 20 characters 0x21..0x7E but parentheses and quotes.
bool isTeamName(std::string_view text);
constexpr const char* teamNameRule =
    "1 to 20 printable ASCII characters without blanks, parentheses or quotes";

/// Whether the league's server passes this text on: 1 to 20 characters 0x20..0x7E, no space, no parenthesis.
bool isSayable(std::string_view text);

}  // namespace plumbline::simspark
