#include "FitOfEverything.h"

#include <algorithm>
#include <cmath>

#include "Shares.h"
#include "gap/diagnosis/Parallel.h"
#include "gap/effects/Effects.h"
#include "optimization/Cmaes.h"

namespace plumbline::bench {

using namespace gap;

namespace {

constexpr int evaluations = 600;
constexpr double firstStep = 0.05;  // of the bounds
constexpr double leastGain = 0.1;   // of the sum of squares

Explanation everything(const Mechanism& robot, int joint, bool imuRecorded) {
  const Mechanism::Joint& at = robot.joints[static_cast<std::size_t>(joint)];
  Explanation causes;
  for (const Effect* effect : effects()) {
    if (effect->id == "command_dropout") continue;
    if (effect->id == "speed_limit" && at.servo.model == Servo::Model::dcMotor) continue;
    for (const Place& place : placesOf(*effect, robot)) {
      const bool wanted = (place.site == Site::joint && place.index == joint) ||
                          (place.site == Site::link && place.index == at.child) ||
                          place.site == Site::everywhere || (place.site == Site::imu && imuRecorded);
      if (wanted) causes.push_back({effect, place, effect->nominal, 0});
    }
  }
  return causes;
}

}  // namespace

Explanation fitOfEverything(const Mechanism& robot, const ChainReplay& chain, bool imuRecorded, int jobs) {
  if (chain.joint() < 0) return {};
  const Explanation causes = everything(robot, chain.joint(), imuRecorded);
  const auto n = static_cast<Eigen::Index>(causes.size());
  SearchSpace space;
  space.start = Eigen::VectorXd::Zero(n);
  space.sigma = Eigen::VectorXd::Constant(n, firstStep);
  space.upper = Eigen::VectorXd::Ones(n);
  space.lower = Eigen::VectorXd::Zero(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Cause& cause = causes[static_cast<std::size_t>(i)];
    if (boundOf(robot, cause, false) < cause.effect->nominal) space.lower[i] = -1;
    if (boundOf(robot, cause, true) <= cause.effect->nominal) space.upper[i] = 0;
  }
  const auto at = [&](const Eigen::VectorXd& x) {
    Explanation tried;
    for (Eigen::Index i = 0; i < n; ++i)
      if (x[i] != 0) tried.push_back(atShare(robot, causes[static_cast<std::size_t>(i)], x[i]));
    return tried;
  };
  CmaesOptions options;
  options.seed = 7;
  options.stop.maxEvaluations = evaluations;
  Cmaes optimizer(space, options);
  while (!optimizer.isDone()) {
    const Eigen::MatrixXd& asked = optimizer.ask();
    std::vector<double> costs(static_cast<std::size_t>(asked.cols()));
    parallel(costs.size(), jobs, [&](std::size_t i) {
      costs[i] = chain.of(at(asked.col(static_cast<Eigen::Index>(i)))).fitting;
    });
    optimizer.tell(costs);
  }
  if (optimizer.bestCost() > (1 - leastGain) * chain.of({}).fitting) return {};
  Eigen::Index most = 0;
  optimizer.best().cwiseAbs().maxCoeff(&most);
  return {atShare(robot, causes[static_cast<std::size_t>(most)], optimizer.best()[most])};
}

}  // namespace plumbline::bench
