#pragma once
#include <string>
#include <vector>

#include "gap/run/Run.h"

namespace plumbline::gap {

/// Reads the run in a folder: run.json, and run.csv or run.csv.gz. Throws RunError where the whole cannot be
/// used; a column that cannot be read is left out and said in `warnings`. Nothing here looks at the robot:
/// see RunCheck.h.
Run readRun(const std::string& folder, std::vector<RunWarning>& warnings);

/// The run folders at a path: the path itself where it holds a run.json or run.csv, else those below it, by
/// name. Throws RunError where there is none.
std::vector<std::string> findRuns(const std::string& path);

/// Writes a run: a folder beside the place, then renamed. Throws RunError where the folder is there already
/// or cannot be written. Numbers have `digits` significant digits, t two more.
struct WriteRunOptions {
  int digits = 6;
  bool packed = true;  ///< run.csv.gz
};
void writeRun(const Run& run, const std::string& folder, WriteRunOptions options = {});

}  // namespace plumbline::gap
