#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "simspark/FieldMessage.h"
#include "simspark/SceneState.h"

namespace plumbline::simspark {

/// Follows a SimSpark monitor's scene for FieldState, at a fraction of SceneState's cost: it reads only the
/// transforms above torsos and ball. The league's server sends 1.8 MB/s of them with 22 robots.
class FieldScene {
public:
  /// Takes in a monitor's message. Empty, or one line why it could not be read.
  std::string update(std::string_view message);
  bool complete() const { return scene_.complete(); }
  /// As fieldState() of a SceneState that got the same messages.
  FieldState state() const;

private:
  /// A transform that counts: which node of the scene it belongs to, and its value.
  struct Transform {
    int node = 0;  ///< in the order in which nodes begin
    Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  };
  using Chain = std::vector<std::size_t>;  ///< places in `transforms`, from the world inwards

  void index(std::string_view message);
  Chain chainOf(const std::vector<int>& nodes);
  std::string readDifference(std::string_view rest);
  Eigen::Matrix4d compose(const Chain& chain) const;

  SceneState scene_;                   ///< of the last whole scene, and the state of the game
  std::vector<Transform> transforms_;  ///< sorted by node
  std::vector<Chain> robots_;          ///< as scene.robots
  Chain ball_;
  int numNodes_ = 0;
};

}  // namespace plumbline::simspark
