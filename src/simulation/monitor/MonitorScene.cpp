#include "simulation/monitor/MonitorScene.h"

#include <cmath>

#include "simspark/FieldWords.h"
#include "simspark/NumberFormat.h"
#include "simulation/league/FieldObstacles.h"

namespace plumbline::simulation {

using simspark::appendGeneral;

namespace {

constexpr float precision = 0.005f;
constexpr const char* bodyMeshTurn =
    "(nd TRF (SLT -1 3.82137e-15 8.74228e-08 -0 8.74228e-08 4.37114e-08 1 0 0 1 "
    "-4.37114e-08 0 0 0 0 1)";
constexpr const char* unmoved = "(nd TRF (SLT 1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1)";

}  // namespace

MonitorScene::Matrix MonitorScene::matrixOf(const Pose3& pose, bool robotAxes) {
  Mat3 axes = pose.linear();
  if (robotAxes) {  // SimSpark's robots have x to the right and y forward
    const Vec3 right = -axes.col(1), forward = axes.col(0);
    axes.col(0) = right;
    axes.col(1) = forward;
  }
  Matrix matrix{};
  for (int column = 0; column < 3; ++column)
    for (int row = 0; row < 3; ++row)
      matrix[static_cast<std::size_t>(4 * column + row)] = static_cast<float>(axes(row, column));
  for (int row = 0; row < 3; ++row)
    matrix[static_cast<std::size_t>(12 + row)] = static_cast<float>(pose.translation()[row]);
  matrix[15] = 1;
  return matrix;
}

void MonitorScene::appendTransform(const Matrix& matrix) {
  text_ += " (SLT";
  for (const float value : matrix) {
    text_ += ' ';
    appendGeneral(text_, value);
  }
  text_ += ')';
}

void MonitorScene::appendIfMoved(const Matrix& matrix, Matrix& lastSent) {
  for (std::size_t i = 0; i < matrix.size(); ++i) {
    if (std::fabs(matrix[i] - lastSent[i]) <= precision) continue;
    appendTransform(matrix);
    lastSent = matrix;
    return;
  }
}

const std::vector<BodyLook>& MonitorScene::looks(int type) {
  auto& cached = looksOfType_[type];
  if (cached.empty()) cached = robotLooks(type);
  return cached;
}

const std::vector<int>& MonitorScene::links(const Player& player) {
  auto& cached = linksOfType_[player.type()];
  if (cached.empty())
    for (const BodyLook& look : looks(player.type())) cached.push_back(player.model().linkIndex(look.link));
  return cached;
}

void MonitorScene::word(std::string_view name, std::string_view value) {
  text_ += '(';
  text_ += name;
  text_ += ' ';
  text_ += value;
  text_ += ')';
}

void MonitorScene::rules(const Rules& rules, const FieldSize& field) {
  const auto number = [this](const char* name, double value) {
    std::string digits;
    appendGeneral(digits, static_cast<float>(value));
    word(name, digits);
  };
  number("FieldLength", field.length);
  number("FieldWidth", field.width);
  number("FieldHeight", 40);
  number("GoalWidth", field.goalWidth);
  number("GoalDepth", field.goalDepth);
  number("GoalHeight", field.goalHeight);
  number("BorderSize", 0);
  number("FreeKickDistance", rules.restarts.distance);
  number("WaitBeforeKickOff", rules.kickOff.after >= 0 ? rules.kickOff.after : rules.time.waitForKickOff);
  number("AgentRadius", rules.moves.agentRadius);
  number("BallRadius", field.ballRadius);
  number("BallMass", ballMass);
  number("RuleGoalPauseTime", rules.time.goalPause);
  number("RuleKickInPauseTime", rules.time.kickPause);
  number("RuleHalfTime", rules.time.half);
  number("PassModeMinOppBallDist", rules.pass.minOpponentDistance);
  number("PassModeDuration", rules.pass.duration);
  for (const simspark::FieldWord& word : simspark::ownFieldWords)
    if (field.*word.size != FieldSize().*word.size) number(word.name, field.*word.size);
}

void MonitorScene::gameState(const Game& game) {
  text_ += "(time ";
  appendGeneral(text_, static_cast<float>(game.time));
  text_ += ')';
  constexpr std::array<const char*, 2> teamWords = {"team_left", "team_right"},
                                       scoreWords = {"score_left", "score_right"};
  for (std::size_t i = 0; i < 2; ++i) {
    if (game.teams[i] == sent_.teams[i]) continue;
    word(teamWords[i], game.teams[i]);
    sent_.teams[i] = game.teams[i];
  }
  if (sent_.half != game.half) word("half", std::to_string(game.half));
  sent_.half = game.half;
  for (std::size_t i = 0; i < 2; ++i) {
    if (game.score[i] != sent_.score[i]) word(scoreWords[i], std::to_string(game.score[i]));
    sent_.score[i] = game.score[i];
  }
  const int mode = static_cast<int>(game.mode);
  if (mode != sent_.mode) word("play_mode", std::to_string(mode));
  sent_.mode = mode;
  constexpr std::array<const char*, 2> waitWords = {"pass_mode_score_wait_left",
                                                    "pass_mode_score_wait_right"};
  for (std::size_t i = 0; i < 2; ++i) {
    if (game.passScoreWait[i] <= 0) continue;
    std::string seconds;
    appendGeneral(seconds, static_cast<float>(game.passScoreWait[i]));
    word(waitWords[i], seconds);
  }
  if (foulsSent_ < 0 || foulsSent_ > game.fouls.count()) foulsSent_ = game.fouls.count();
  for (const Foul& foul : game.fouls.since(foulsSent_))
    word("foul", std::to_string(foul.index) + ' ' + std::to_string(static_cast<int>(foul.kind)) +
                     (foul.side == TeamSide::right ? " 2 " : " 1 ") + std::to_string(foul.unum));
  foulsSent_ = game.fouls.count();
}

const std::string& MonitorScene::full(const Simulation& simulation) {
  sent_ = SentGame();
  robots_.clear();
  text_ = "(";
  rules(simulation.rules(), simulation.field());
  text_ += "(play_modes";
  for (const std::string_view name : simspark::playModeNames) {
    text_ += ' ';
    text_ += name;
  }
  text_ += ')';
  gameState(simulation.game());
  text_ += ")(RSG 0 1)(";
  text_ += fieldScene();
  sentBall_ = matrixOf(simulation.world().ball().pose, false);
  text_ += "(nd TRF";
  appendTransform(sentBall_);
  text_ +=
      "(nd StaticMesh (setVisible 1) (load models/soccerball.obj) (sSc 0.042 0.042 0.042)"
      "(resetMaterials soccerball_rcs-soccerball.png)))";
  for (const auto& [id, player] : simulation.allPlayers()) appendRobot(simulation, *player, robots_[id]);
  text_ += ')';
  return text_;
}

void MonitorScene::appendRobot(const Simulation& simulation, const Player& player, RobotView& view) {
  view.selected = player.selected;
  text_ += unmoved;
  const auto& bodies = looks(player.type());
  const auto& bodyLinks = links(player);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyLook& look = bodies[i];
    view.sentMatrices.push_back(
        matrixOf(simulation.world().linkState(player.robot, bodyLinks[i]).pose, true));
    text_ += "(nd TRF";
    appendTransform(view.sentMatrices.back());
    if (look.turned) text_ += bodyMeshTurn;
    if (look.mesh.empty())
      text_ += "(nd SMN (setVisible 1) (load " + look.shape + ") (sSc " + look.scale + ") (sMat " +
               look.material + "))";
    else
      text_ += "(nd StaticMesh (setVisible 1) (load models/" + look.mesh + ") (sSc " + look.scale +
               ")(resetMaterials " + materialNames(look.materials, player.type(), player.unum, player.side) +
               "))";
    if (look.turned) text_ += ')';
    if (look.marker) {
      text_ += unmoved;
      text_ += "(nd SMN (setVisible ";
      text_ += player.selected ? '1' : '0';
      text_ += ") (setTransparent) (load StdUnitCylinder 1 1) (sSc 0.2 0.2 0.02) (sMat matSelect)))";
    }
    text_ += ')';
  }
  text_ += ')';
}

const std::string& MonitorScene::difference(const Simulation& simulation) {
  text_ = "(";
  gameState(simulation.game());
  text_ += ")(RDS 0 1)(";
  text_ += fieldDifference();
  text_ += "(nd";
  appendIfMoved(matrixOf(simulation.world().ball().pose, false), sentBall_);
  text_ += "(nd StaticMesh))";
  for (const auto& [id, player] : simulation.allPlayers())
    if (const auto view = robots_.find(id); view != robots_.end())
      appendRobotDifference(simulation, *player, view->second);
  text_ += ')';
  return text_;
}

void MonitorScene::appendRobotDifference(const Simulation& simulation, const Player& player,
                                         RobotView& view) {
  text_ += "(nd";
  const auto& bodies = looks(player.type());
  const auto& bodyLinks = links(player);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const BodyLook& look = bodies[i];
    text_ += "(nd";
    appendIfMoved(matrixOf(simulation.world().linkState(player.robot, bodyLinks[i]).pose, true),
                  view.sentMatrices[i]);
    text_ += look.mesh.empty() ? "(nd SMN)" : look.turned ? "(nd(nd StaticMesh))" : "(nd StaticMesh)";
    if (look.marker) {
      text_ += "(nd(nd SMN";
      if (player.selected != view.selected) text_ += player.selected ? " (setVisible 1)" : " (setVisible 0)";
      text_ += "))";
      view.selected = player.selected;
    }
    text_ += ')';
  }
  text_ += ')';
}

}  // namespace plumbline::simulation
