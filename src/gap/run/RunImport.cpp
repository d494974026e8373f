#include "gap/run/RunImport.h"

#include <cmath>
#include <optional>

#include "gap/run/ColumnStatistics.h"
#include "gap/run/ImportMap.h"
#include "gap/run/RecordingImport.h"
#include "robot/MechanismFile.h"

namespace plumbline::gap {
namespace {

void requireOneEach(const ImportMap& map, const ImportOptions& options) {
  const std::size_t files = options.recordings.size(), tables = map.recordings.size();
  if (files == tables) return;
  if (!map.severalTables)
    throw RunError(options.map + ": describes one recording, but " + std::to_string(files) +
                   " are given; write tables: with an entry for each, in their order");
  throw RunError(options.map + ": tables has " + std::to_string(tables) + " entries, but " +
                 std::to_string(files) + " recordings are given; give one for each, in the order of tables");
}

/// The robot whose limits show units; a name that no file has is no mistake here.
class RobotOfMap {
public:
  RobotOfMap(const ImportOptions& options, const ImportMap& map) : options_(options), map_(map) {}

  /// Null if the robot is not known; what needs it asks for --robot.
  const Mechanism* find() {
    if (!looked_) {
      looked_ = true;
      if (!options_.robot.empty())
        robot_ = namedMechanism(options_.robot);
      else if (isKnownMechanism(map_.head.robot))
        robot_ = findMechanism(map_.head.robot);
    }
    return robot_ ? &*robot_ : nullptr;
  }

private:
  const ImportOptions& options_;
  const ImportMap& map_;
  bool looked_ = false;
  std::optional<Mechanism> robot_;
};

}  // namespace

ImportedRun importRecordings(const ImportOptions& options) {
  const ImportMap map = readImportMap(options.map);
  requireOneEach(map, options);
  RobotOfMap robot(options, map);
  ImportedRun result;
  result.run = map.head;
  result.run.folder = options.recordings.front();
  std::vector<TimedChannels> parts;
  for (std::size_t i = 0; i < map.recordings.size(); ++i) {
    RecordingImport part(map, map.recordings[i], options.recordings[i], [&] { return robot.find(); });
    for (const TimedChannels& before : parts) part.requireOthers(before);
    part.run(result);
    parts.push_back(part.take());
  }
  if (parts.size() == 1) {
    result.run.t = std::move(parts[0].t);
    result.run.channels = std::move(parts[0].channels);
  } else {
    MergedChannels merged = mergeChannels(parts, {map.head.linearCommands, map.timingStated});
    result.run.t = std::move(merged.t);
    result.run.channels = std::move(merged.channels);
    if (!map.timingStated) result.run.timing = std::move(merged.timing);
    result.merged = std::move(merged.notes);
  }
  const double begin = result.run.t.front();
  for (double& t : result.run.t) t -= begin;
  if (result.run.rateHz == 0) result.run.rateHz = std::round(1e4 / medianStep(result.run.t)) / 1e4;
  return result;
}

ImportedRun importRecording(const std::string& mapFile, const std::string& recording) {
  return importRecordings({mapFile, {recording}, ""});
}

}  // namespace plumbline::gap
