#pragma once
#include <string>
#include <vector>

#include "gap/run/Run.h"

namespace plumbline::gap {

/// Reads the run in a folder: run.json, and run.csv or run.csv.gz. Throws RunError if the run cannot be used;
/// a column that cannot be read is left out, with an entry in `warnings`. The robot is checked separately:
/// see RunCheck.h.
Run readRun(const std::string& folder, std::vector<RunWarning>& warnings);

/// The run folders at a path: the path itself if it has a run.json or run.csv, else those below it, by name.
/// Throws RunError if there is none.
std::vector<std::string> findRuns(const std::string& path);

/// Writes a run into a temporary folder, which is then renamed. Throws RunError if the folder exists or
/// cannot be written. Numbers have `digits` significant digits, t two more.
struct WriteRunOptions {
  int digits = 6;
  bool packed = true;  ///< run.csv.gz
};
void writeRun(const Run& run, const std::string& folder, WriteRunOptions options = {});

}  // namespace plumbline::gap
