#pragma once
#include <vector>

#include "motion/MotionParameters.h"

namespace plumbline::motion {

/// Where a kick wants the ball and where the ball then goes, as numbers for a search: ballX, ballY [mm] and
/// direction [deg]. The keyframes stay.
class SearchedKickPlace {
public:
  /// Throws std::invalid_argument for a motion that is no kick.
  explicit SearchedKickPlace(KeyframeMotion kick);

  const std::vector<SearchedNumber>& list() const { return list_; }
  /// The kick with these numbers as its file has it: rounded to millimetres and hundredths of a degree.
  KeyframeMotion written(const Eigen::VectorXd& values) const;

private:
  KeyframeMotion first_;
  std::vector<SearchedNumber> list_;
};

}  // namespace plumbline::motion
