#include "servo/RobotSimulation.h"

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>

#include "framework/NearestName.h"
#include "framework/SelfRegistration.h"

namespace plumbline::servo {
namespace {

std::map<std::string, RobotSimulations::Maker>& simulationMakers() {
  static std::map<std::string, RobotSimulations::Maker> map;
  return map;
}

/// Engines that were left out of this program because their library was not installed, and its package.
std::map<std::string, std::string> enginesLeftOut() {
  std::map<std::string, std::string> result;
  std::istringstream words(PLUMBLINE_LEFT_OUT);
  for (std::string engine, package; words >> engine >> package;) result[engine] = package;
  return result;
}

}  // namespace

Vec3 RobotSimulation::comVelocity() const {
  Vec3 momentum = Vec3::Zero();
  double mass = 0;
  const std::vector<Mechanism::Link>& links = mechanism().links;
  for (std::size_t i = 0; i < links.size(); ++i) {
    const simulation::BodyState& state = link(static_cast<int>(i));
    momentum += links[i].mass *
                (state.linearVelocity + state.angularVelocity.cross(state.pose.linear() * links[i].com));
    mass += links[i].mass;
  }
  return momentum / mass;
}

bool RobotSimulations::add(const std::string& engine, Maker maker) {
  if (!simulationMakers().emplace(engine, std::move(maker)).second)
    endLinkedTwice("engines for servo robots", engine);
  return true;
}

std::vector<std::string> RobotSimulations::names() {
  std::vector<std::string> result;
  for (const auto& entry : simulationMakers()) result.push_back(entry.first);
  return result;
}

void RobotSimulations::require(const std::string& engine, const std::vector<std::string>& others) {
  std::vector<std::string> known = others;
  for (const std::string& name : names()) known.push_back(name);
  if (std::ranges::find(known, engine) != known.end()) return;
  std::string list;
  for (const std::string& name : known) list += (list.empty() ? "" : ", ") + name;
  const std::map<std::string, std::string> leftOut = enginesLeftOut();
  if (const auto found = leftOut.find(engine); found != leftOut.end())
    throw std::invalid_argument("engine " + engine + " is not in this program: install " + found->second +
                                ", configure and build again; there are: " + list);
  for (const auto& entry : leftOut) known.push_back(entry.first);
  const std::string nearest = suggestion(engine, known);
  throw std::invalid_argument("there is no engine " + engine +
                              (nearest.empty() ? "; there are: " + list : nearest));
}

std::unique_ptr<RobotSimulation> RobotSimulations::make(const std::string& engine, const Mechanism& mechanism,
                                                        const RobotSimulationOptions& options) {
  require(engine);
  return simulationMakers().at(engine)(mechanism, options);
}

}  // namespace plumbline::servo
