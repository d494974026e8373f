#pragma once
#include <array>
#include <map>
#include <optional>
#include <string>

#include "simulation/Simulation.h"
#include "simulation/monitor/SceneTexts.h"

namespace plumbline::simulation {

/// The messages to monitors: a whole scene, then differences to the last message. A transform is sent again
/// only if one of its sixteen numbers changed by more than 0.005. Nodes, order and number format are those of
/// the league's server, which its viewers and trainers read.
class MonitorScene {
public:
  /// The whole scene; the next difference is relative to it.
  const std::string& full(const Simulation& simulation);
  /// What changed since the last call of either. A scene that got or lost a robot needs full() first.
  const std::string& difference(const Simulation& simulation);

private:
  using Matrix = std::array<float, 16>;  ///< by columns, SimSpark's axes
  struct RobotView {
    std::vector<Matrix> sentMatrices;  ///< of its links, as the monitors have them
    bool selected = false;
  };
  struct SentGame {
    std::array<std::string, 2> teams;
    int half = 0, mode = -1;
    std::array<int, 2> score = {-1, -1};
  };

  void rules(const Rules& rules, const FieldSize& field);
  void gameState(const Game& game);
  void word(std::string_view name, std::string_view value);
  void appendRobot(const Simulation& simulation, const Player& player, RobotView& view);
  void appendRobotDifference(const Simulation& simulation, const Player& player, RobotView& view);
  void appendTransform(const Matrix& matrix);
  /// " (SLT ...)" if the matrix moved far enough from what was sent.
  void appendIfMoved(const Matrix& matrix, Matrix& lastSent);
  static Matrix matrixOf(const Pose3& pose, bool robotAxes);

  const std::vector<BodyLook>& looks(int type);
  const std::vector<int>& links(const Player& player);

  std::string text_;
  SentGame sent_;
  int foulsSent_ = -1;  ///< index of the last; -1: none is sent from before the first message
  Matrix sentBall_{};
  std::map<PlayerId, RobotView> robots_;
  std::map<int, std::vector<BodyLook>> looksOfType_;
  std::map<int, std::vector<int>> linksOfType_;
};

}  // namespace plumbline::simulation
