#pragma once
#include <vector>

#include "modules/modeling/selflocator/PoseBelief.h"

namespace plumbline {

/// Poses that one image alone speaks for, best first, for sensor resetting (Lenser and Veloso, "Sensor
/// Resetting Localization for Poorly Modelled Mobile Robots", 2000). Two landmarks give one pose by least
/// squares; one landmark and a line give one per segment of the map the line could be. Nothing from less.
class PoseProposals {
public:
  static constexpr std::size_t maxProposals = 4;

  explicit PoseProposals(const FieldMap& map) : map_(map) {}

  /// The proposals of this image, each with the covariance of the image; valid until the next call.
  const std::vector<PoseBelief>& find(const FieldView& view);

private:
  struct Scored {
    PoseBelief belief;
    double score;  ///< smaller is better
  };
  Pose2 fromLandmarks(const FieldView& view) const;
  void fromLandmarkAndLine(const FieldView& view, const SeenFieldLine& line);
  void keep(const PoseUpdate& update, const Pose2& pose, std::size_t numLines);

  const FieldMap& map_;
  std::vector<Scored> scored_;
  std::vector<PoseBelief> found_;
};

}  // namespace plumbline
