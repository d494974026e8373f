// Keyframe motions.
#include <cmath>

#include "fuzz/Readers.h"
#include "motion/KeyframeReader.h"
#include "simspark/LeagueRobots.h"

namespace plumbline::fuzz {
namespace {

void motionFile(std::string_view bytes) {
  static const RobotModel robot = simsparkRobot(0);
  const std::string path = scratchFile("motions/one.yaml", bytes);
  scratchFile("motions/other.yaml", "mirror: one\n");
  refusesInOneLine([&] {
    motion::readKeyframeFile(path, robot, {scratchFolder() + "/motions"});
    motion::readKeyframeFile(scratchFolder() + "/motions/other.yaml", robot, {scratchFolder() + "/motions"});
  });
}

std::vector<std::string> motionFileSeeds() {
  std::vector<std::string> all = contentsOf("config/motions", ".yaml");
  all.push_back("mirror: other\n");
  return all;
}

const Registered motionFileTarget({"motionFile", motionFile, motionFileSeeds, 1200});

}  // namespace
}  // namespace plumbline::fuzz
