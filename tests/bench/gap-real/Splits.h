#pragma once
#include <string>
#include <vector>

#include "RealRuns.h"

namespace plumbline::bench {

/// A robot whose recordings are in the folder of the same name: what fits and what tests, and what a page
/// says of it.
struct RealRobot {
  std::string id, folder, model, title;  ///< of figures; of recordings; of the library; of the page
  std::size_t maxCauses = 0;
  std::vector<RealSplit> splits;
  std::string about, limits;  ///< paragraphs before and after the splits
};

/// An XL330 servo with a pendulum (three splits by firmware gain) and an SO-101 arm (three by motions).
std::vector<RealRobot> realRobots();

}  // namespace plumbline::bench
