#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "training/Walker.h"

namespace plumbline::bench {

/// A robot that is measured: in its world, with a walk.
struct Subject {
  std::string name;  ///< type0 .. type4, type0_plain, type3_plain, nao-bullet, nao-mujoco; "@server"
  walking::WalkGaits gaits;
  std::function<std::unique_ptr<training::Walker>(const walking::WalkGaits&)> make;
  double walkingSpeed = 0.3;  ///< forward, while it is pushed [m/s]
  bool onServer = false;      ///< a SimSpark server's: not to be pushed, and its true pose is coarse
  std::string peer;           ///< whose forward speed stands beside its own
  double peerForward = 0;     ///< [m/s]
  /// Targets: those of the league's robots, or what the NAO's own teams walk.
  double forward = 1.0, backward = 0.6, sideways = 0.5, turn = 120;  ///< [m/s, deg/s]

  std::unique_ptr<training::Walker> walker() const { return make(gaits); }
};

/// All robots that the benchmark knows, in the order of its tables.
std::vector<std::string> subjectNames();
/// Throws std::invalid_argument for another name, with those there are.
Subject subjectOf(const std::string& name);

/// Of the chosen robots those that are not "_plain", or all.
std::vector<Subject> subjects(const std::vector<std::string>& names, bool plain);
/// Those of them that are in this process.
std::vector<Subject> embedded(std::vector<Subject> subjects);

}  // namespace plumbline::bench
