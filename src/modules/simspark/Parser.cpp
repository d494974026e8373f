#include "modules/simspark/Parser.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/Angle.h"
#include "modules/simspark/PolarPointOf.h"
#include "simspark/LeagueRobots.h"
#include "simspark/PerceptLimits.h"

namespace plumbline {

MAKE_MODULE(Parser)

namespace {

constexpr double nominalCycle = 0.02;   ///< of SimSpark [s]
constexpr double longestCycle = 0.5;    ///< a later message is of a new start [s]
constexpr double shortestCycle = 1e-3;  ///< what comes sooner says nothing of the cycle's length [s]

}  // namespace

void Parser::init() {
  const AgentOptions& options = object<AgentOptions>();
  player_.team = options.team;
  player_.number = options.number;
  player_.robot = simsparkRobotName(options.type);
  cycleSeconds_ = nominalCycle;
}

void Parser::execute() {
  ++cycle_;
  restarted_ = false;
  if (theSimSparkInfo) {
    restarted_ = connections_ > 0 && theSimSparkInfo->connections != connections_;
    connections_ = theSimSparkInfo->connections;
  }
  auto error = parser_.parse(theServerMessageText->text, next_);
  if (!error && next_.time == 0 && next_.gameState.playMode.empty())
    error = simspark::ParseError{0, "neither time nor play mode in it"};
  if (!error && !(std::abs(next_.time) <= simspark::maxServerTime))
    error = simspark::ParseError{0, "its time is beyond all bounds"};
  readable_ = !error;
  if (error) {
    log.warning() << "message " << cycle_ << " of the simulator, byte " << error->position << ": "
                  << error->what << "; it is left out";
    return;
  }
  std::string first;
  if (const int dropped = simspark::dropImplausible(next_, message_, first); dropped > 0) {
    dropped_ += static_cast<unsigned>(dropped);
    log.warning() << "message " << cycle_ << " of the simulator: " << first
                  << " is beyond what can be measured; left out, " << dropped_ << " such so far";
  }
  std::swap(message_, next_);
  const double passed = message_.time - time_;
  restarted_ = restarted_ || (started_ && (passed < 0 || passed > longestCycle));
  if (started_ && !restarted_ && passed >= shortestCycle) cycleSeconds_ = passed;
  started_ = true;
  if (restarted_) {
    cycleSeconds_ = nominalCycle;
    player_.sideKnown = false;
    log << "the simulator restarted";
  }
  time_ = message_.time;

  const simspark::GameState& game = message_.gameState;
  if (game.unum) player_.number = *game.unum;
  if (game.side) {
    player_.leftSide = *game.side != "right";
    player_.sideKnown = true;
  }
}

void Parser::update(FrameInfo* theFrameInfo) {
  theFrameInfo->time = time_;
  theFrameInfo->cycleSeconds = cycleSeconds_;
  theFrameInfo->cycle = cycle_;
  theFrameInfo->restarted = restarted_;
}

void Parser::update(GameState* theGameState) {
  if (!readable_) return;
  const simspark::GameState& game = message_.gameState;
  theGameState->playMode = playModeOf(game.playMode, player_.leftSide);
  theGameState->time = game.time;
  theGameState->ownScore = player_.leftSide ? game.scoreLeft : game.scoreRight;
  theGameState->opponentScore = player_.leftSide ? game.scoreRight : game.scoreLeft;
}

void Parser::update(PlayerInfo* thePlayerInfo) { *thePlayerInfo = player_; }

void Parser::update(JointData* theJointData) {
  if (!readable_) return;
  for (std::size_t i = 0; i < message_.angle.size(); ++i)
    if (message_.angle[i]) theJointData->angles[i] = *message_.angle[i];
}

void Parser::update(SensorData* theSensorData) {
  if (!readable_) return;
  theSensorData->gyro = message_.gyro;
  theSensorData->acc = message_.acc;
  theSensorData->leftFoot = FootForceData(message_.leftFoot);
  theSensorData->rightFoot = FootForceData(message_.rightFoot);
  theSensorData->leftToe = FootForceData(message_.leftToe);
  theSensorData->rightToe = FootForceData(message_.rightToe);
}

void Parser::update(VisionInfo* theVisionInfo) { theVisionInfo->newImage = readable_ && message_.see; }

void Parser::update(PolarBallPercept* thePolarBallPercept) {
  thePolarBallPercept->seen = false;
  if (!readable_ || !message_.see) return;
  for (const simspark::SeenObject& object : message_.see->objects) {
    if (object.name != "B") continue;
    thePolarBallPercept->seen = true;
    thePolarBallPercept->position = polarPointOf(object.position);
  }
}

void Parser::update(PolarLandmarkPercept* thePolarLandmarkPercept) {
  thePolarLandmarkPercept->landmarks.clear();
  if (!readable_ || !message_.see) return;
  for (const simspark::SeenObject& object : message_.see->objects) {
    if (object.name == "B") continue;
    PolarLandmark& landmark = thePolarLandmarkPercept->landmarks.emplace_back();
    landmark.name = object.name;
    landmark.position = polarPointOf(object.position);
  }
}

void Parser::update(PolarLinePercept* thePolarLinePercept) {
  thePolarLinePercept->lines.clear();
  if (!readable_ || !message_.see) return;
  for (const simspark::SeenLine& seen : message_.see->lines) {
    PolarLine& line = thePolarLinePercept->lines.emplace_back();
    line.a = polarPointOf(seen.a);
    line.b = polarPointOf(seen.b);
  }
}

void Parser::update(PolarPlayerPercept* thePolarPlayerPercept) {
  thePolarPlayerPercept->players.clear();
  if (!readable_ || !message_.see) return;
  thePolarPlayerPercept->players.reserve(message_.see->players.size());
  for (const simspark::SeenPlayer& seen : message_.see->players) {
    PolarPlayer& player = thePolarPlayerPercept->players.emplace_back();
    player.team = seen.team;
    player.number = seen.unum;
    player.parts.reserve(seen.parts.size());
    for (const simspark::SeenBodyPart& part : seen.parts) {
      PolarBodyPart& bodyPart = player.parts.emplace_back();
      bodyPart.name = part.name;
      bodyPart.position = polarPointOf(part.position);
    }
  }
}

void Parser::update(HearPercept* theHearPercept) {
  theHearPercept->messages.clear();
  if (!readable_) return;
  for (const simspark::HeardMessage& heard : message_.heard) {
    HeardText& text = theHearPercept->messages.emplace_back();
    text.team = heard.team;
    text.time = heard.time;
    text.self = heard.self;
    text.direction = heard.direction;
    text.text = heard.text;
  }
}

void Parser::update(GroundTruth* theGroundTruth) {
  theGroundTruth->valid = readable_ && message_.groundTruth && player_.sideKnown;
  if (!theGroundTruth->valid) return;
  // On the server's field; the right team's own frame is turned by half a turn.
  const Pose3 T_field_world = player_.leftSide ? Pose3(Pose3::Identity()) : rotationZ(pi);
  theGroundTruth->T_field_torso = T_field_world * message_.groundTruth->T_world_torso;
  theGroundTruth->ball = T_field_world * message_.groundTruth->ball;
}

TeamPlayMode playModeOf(const std::string& word, bool leftSide) {
  struct Mode {
    const char* word;
    TeamPlayMode ofLeft, ofRight;  ///< as the left and as the right team sees it
  };
  static constexpr std::array<Mode, 21> modes = {{
      {"BeforeKickOff", TeamPlayMode::beforeKickOff, TeamPlayMode::beforeKickOff},
      {"KickOff_Left", TeamPlayMode::kickOffOwn, TeamPlayMode::kickOffOpponent},
      {"KickOff_Right", TeamPlayMode::kickOffOpponent, TeamPlayMode::kickOffOwn},
      {"PlayOn", TeamPlayMode::playOn, TeamPlayMode::playOn},
      {"KickIn_Left", TeamPlayMode::kickInOwn, TeamPlayMode::kickInOpponent},
      {"KickIn_Right", TeamPlayMode::kickInOpponent, TeamPlayMode::kickInOwn},
      {"corner_kick_left", TeamPlayMode::cornerOwn, TeamPlayMode::cornerOpponent},
      {"corner_kick_right", TeamPlayMode::cornerOpponent, TeamPlayMode::cornerOwn},
      {"goal_kick_left", TeamPlayMode::goalKickOwn, TeamPlayMode::goalKickOpponent},
      {"goal_kick_right", TeamPlayMode::goalKickOpponent, TeamPlayMode::goalKickOwn},
      {"offside_left", TeamPlayMode::offsideOwn, TeamPlayMode::offsideOpponent},
      {"offside_right", TeamPlayMode::offsideOpponent, TeamPlayMode::offsideOwn},
      {"GameOver", TeamPlayMode::gameOver, TeamPlayMode::gameOver},
      {"Goal_Left", TeamPlayMode::goalOwn, TeamPlayMode::goalOpponent},
      {"Goal_Right", TeamPlayMode::goalOpponent, TeamPlayMode::goalOwn},
      {"free_kick_left", TeamPlayMode::freeKickOwn, TeamPlayMode::freeKickOpponent},
      {"free_kick_right", TeamPlayMode::freeKickOpponent, TeamPlayMode::freeKickOwn},
      {"direct_free_kick_left", TeamPlayMode::directFreeKickOwn, TeamPlayMode::directFreeKickOpponent},
      {"direct_free_kick_right", TeamPlayMode::directFreeKickOpponent, TeamPlayMode::directFreeKickOwn},
      {"pass_left", TeamPlayMode::passOwn, TeamPlayMode::passOpponent},
      {"pass_right", TeamPlayMode::passOpponent, TeamPlayMode::passOwn},
  }};
  for (const Mode& mode : modes)
    if (word == mode.word) return leftSide ? mode.ofLeft : mode.ofRight;
  return TeamPlayMode::unknown;
}

}  // namespace plumbline
