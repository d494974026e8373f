#include "gap/record/Postures.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "framework/ConfigFile.h"
#include "framework/ConfigFolder.h"
#include "framework/ConfigurationError.h"
#include "framework/NearestName.h"
#include "gap/record/Excitation.h"
#include "math/Random.h"

namespace plumbline::gap {
namespace {

/// One of a robot's postures; nothing if they have none of that name.
std::optional<std::vector<double>> postureIn(const ConfigSection& postures, const std::string& name,
                                             const Mechanism& robot) {
  if (!postures.has(name)) return std::nullopt;
  std::vector<double> q = neutralPosture(robot);
  const ConfigSection posture = postures.section(name);
  for (const std::string& joint : posture.keys()) {
    const int index = robot.jointIndex(joint);
    if (index < 0)
      posture.fail(joint, "is no joint of " + robot.name + suggestion(joint, robot.jointNames()));
    q[static_cast<std::size_t>(index)] = posture.get<double>(joint);
  }
  return q;
}

}  // namespace

std::vector<double> neutralPosture(const Mechanism& robot) {
  std::vector<double> q;
  for (const Mechanism::Joint& joint : robot.joints) q.push_back(std::clamp(0.0, joint.lower, joint.upper));
  return q;
}

std::optional<std::vector<double>> namedPosture(const std::string& name, const Mechanism& robot,
                                                const std::string& folder) {
  const auto isThere = [](const std::string& path) {
    std::error_code error;
    return std::filesystem::exists(path, error);
  };
  const std::string here = (std::filesystem::path(folder) / "postures.yaml").string(),
                    own = configPath("robots/" + robot.name + "/postures.yaml"),
                    shared = configPath("excitation/postures.yaml");
  for (const std::string& path : {here, own, shared}) {
    if (!isThere(path)) continue;
    const ConfigFile file(path);
    if (path == own) return postureIn(file.root(), name, robot);
    if (file.root().has(robot.name)) return postureIn(file.root().section(robot.name), name, robot);
  }
  if (name == "hang") return neutralPosture(robot);
  return std::nullopt;
}

std::vector<std::vector<int>> jointsInTurn(const Mechanism& robot) {
  // A limb begins at a joint on the base, or where a link carries more than one joint.
  std::vector<std::vector<int>> limbs;
  std::vector<int> limbOf(robot.joints.size(), -1), children(robot.links.size());
  for (const Mechanism::Joint& joint : robot.joints) ++children[static_cast<std::size_t>(joint.parent)];
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    const int parent = robot.joints[j].parent;
    if (parent == 0 || children[static_cast<std::size_t>(parent)] > 1) {
      limbOf[j] = static_cast<int>(limbs.size());
      limbs.emplace_back();
    } else {
      limbOf[j] = limbOf[static_cast<std::size_t>(parent) - 1];
    }
    if (robot.joints[j].driver < 0) limbs[static_cast<std::size_t>(limbOf[j])].push_back(static_cast<int>(j));
  }
  std::size_t longest = 0;
  for (const std::vector<int>& limb : limbs) longest = std::max(longest, limb.size());
  if (longest == 0) return {};
  std::vector<std::vector<int>> groups(longest);
  for (std::size_t l = 0; l < limbs.size(); ++l)
    for (std::size_t k = 0; k < limbs[l].size(); ++k) groups[(k + l) % longest].push_back(limbs[l][k]);
  std::erase_if(groups, [](const std::vector<int>& group) { return group.empty(); });
  return groups;
}

std::vector<std::vector<double>> gravityLoadings(const Mechanism& robot, const std::vector<double>& home,
                                                 double share, int count, std::uint64_t seed) {
  Random random(seed);
  const auto draw = [&] {
    std::vector<double> q = home;
    for (std::size_t j = 0; j < q.size(); ++j) {
      const Mechanism::Joint& joint = robot.joints[j];
      const double x = random.uniform(-1, 1), way = x > 0 ? std::min(M_PI, joint.upper - home[j])
                                                          : std::min(M_PI, home[j] - joint.lower);
      q[j] += share * x * way;
      if (joint.driver >= 0) q[j] = joint.driven(q[static_cast<std::size_t>(joint.driver)]);
    }
    return q;
  };
  constexpr int candidates = 200;
  std::vector<std::vector<double>> drawn, torques;
  std::vector<double> scale(robot.joints.size(), 1e-9);
  for (int i = 0; i < candidates; ++i) {
    drawn.push_back(draw());
    torques.push_back(gravityTorques(robot, drawn.back()));
    for (std::size_t j = 0; j < scale.size(); ++j) scale[j] = std::max(scale[j], std::abs(torques.back()[j]));
  }
  // Greedy: the one farthest from those taken, each joint's torque in units of its largest.
  std::vector<std::vector<double>> result;
  std::vector<double> nearest(drawn.size(), 0);
  std::vector<std::size_t> taken;
  for (std::size_t i = 0; i < drawn.size(); ++i)
    for (std::size_t j = 0; j < scale.size(); ++j) nearest[i] += std::abs(torques[i][j]) / scale[j];
  for (int n = 0; n < count; ++n) {
    const auto best =
        static_cast<std::size_t>(std::max_element(nearest.begin(), nearest.end()) - nearest.begin());
    result.push_back(drawn[best]);
    for (std::size_t i = 0; i < drawn.size(); ++i) {
      double distance = 0;
      for (std::size_t j = 0; j < scale.size(); ++j)
        distance += std::abs(torques[i][j] - torques[best][j]) / scale[j];
      nearest[i] = n == 0 ? distance : std::min(nearest[i], distance);
    }
  }
  return result;
}

}  // namespace plumbline::gap
