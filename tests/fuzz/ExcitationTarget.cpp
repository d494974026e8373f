// Programs that a robot plays for a recording.
#include <cmath>

#include "fuzz/Readers.h"
#include "gap/record/ExcitationFile.h"
#include "robot/MechanismFile.h"

namespace plumbline::fuzz {
namespace {

void excitationFile(std::string_view bytes) {
  static const Mechanism robot = findMechanism("xl330_pendulum");
  const std::string path = scratchFile("program.yaml", bytes);
  refusesInOneLine([&] {
    const gap::Excitation program = gap::readExcitation(path, robot);
    require(std::isfinite(program.duration) && program.duration <= 3600, "a program without an end");
    if (program.walk || program.duration > 60) return;
    const gap::CommandTable table = gap::playExcitation(program, robot, 50);
    for (const auto& joint : table.commands)
      for (const double command : joint) require(std::isfinite(command), "a command that is no number");
  });
}

std::vector<std::string> excitationFileSeeds() { return contentsOf("config/excitation", ".yaml"); }

const Registered excitationFileTarget({"excitationFile", excitationFile, excitationFileSeeds, 1200});

}  // namespace
}  // namespace plumbline::fuzz
