#pragma once
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "gap/run/ImportMap.h"
#include "gap/run/RunImport.h"
#include "gap/run/TableMerge.h"
#include "gap/run/UnitGuess.h"
#include "robot/Mechanism.h"

namespace plumbline::gap {

/// One recording on its way to channels: read, its columns found by the map, units and signs applied.
class RecordingImport {
public:
  /// `robot` gives the robot, or null; it is called only if a unit has to be guessed. `map` and `part` must
  /// outlive this object.
  RecordingImport(const ImportMap& map, const RecordingMap& part, std::string recording,
                  std::function<const Mechanism*()> robot);

  /// A channel of another recording must not come from this one, too.
  void requireOthers(const TimedChannels& other);
  /// Adds columns that were not used, lines without a time and guesses to the result.
  void run(ImportedRun& result);
  TimedChannels take() { return std::move(channels_); }

private:
  /// A channel before its unit is known.
  struct Source {
    std::string to, from;
    const ColumnRule* rule = nullptr;
    std::vector<double> values;
  };

  void takeTime(ImportedRun& result);
  void collect(const ColumnRule& rule);
  bool collectStar(const ColumnRule& rule, const std::string& from);
  void add(const ColumnRule& rule, const std::string& to, const std::string& from);
  void guessUnits(ImportedRun& result);
  void guessGroup(ChannelKind kind, bool sliding, std::vector<Source*> group, UnitGuess::Known& known,
                  ImportedRun& result);
  void put(const Source& source, double unit);
  bool slides(const std::string& channel) const;
  const std::vector<double>& column(const ConfigSection& entry, const std::string& name);
  void listUnused(ImportedRun& result) const;

  const ImportMap& map_;
  const RecordingMap& part_;
  const std::string recording_;
  const std::function<const Mechanism*()> robot_;
  bool isBag_ = false;
  Table table_;
  std::vector<std::size_t> kept_;  ///< lines with a time
  std::set<std::string> used_;
  std::set<std::string> taken_;  ///< channels of other recordings
  std::vector<Source> sources_;
  TimedChannels channels_;
};

}  // namespace plumbline::gap
