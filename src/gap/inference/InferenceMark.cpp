#include "gap/inference/InferenceMark.h"

#include "gap/diagnosis/MarkDump.h"

namespace plumbline::gap {

std::string markOf(const Mechanism& robot, const std::vector<Trial>& trials,
                   const InferenceOptions& options) {
  MarkDump dump;
  dump.add(std::string("sets"));
  dump.addProgram();
  dump.addLibrary();
  dump.add(robot);
  dump.add(trials);
  // Without influence: jobs, memory, progress. Noise and groups follow from the recordings.
  const auto& [jobs, mostCauses, memory, progress] = options;
  dump.add(mostCauses);
  return dump.text();
}

}  // namespace plumbline::gap
