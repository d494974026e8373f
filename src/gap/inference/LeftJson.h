#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gap/inference/HoldOut.h"

namespace plumbline::gap {

/// A recording as `gap.runs` of an answer and `runs` of a check list it: root mean squares in each signal's
/// own unit, floor null where there is none.
nlohmann::json leftJson(const RecordingLeft& left);

/// What bin/gap check writes, but for what the answer claims.
nlohmann::json checkJson(const std::vector<RecordingLeft>& recordings);

/// For people: a line per recording and per joint of it that shows a gap, in mrad (mm).
std::string leftTable(const std::vector<RecordingLeft>& recordings);

}  // namespace plumbline::gap
