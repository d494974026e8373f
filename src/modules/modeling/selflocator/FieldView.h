#pragma once
#include <vector>

#include "math/Angle.h"
#include "math/Types.h"
#include "parameters/Parameter.h"

namespace plumbline {

/// What vision shows: standard deviations of its errors, and how far it reaches to each side. The defaults
/// are SimSpark's (restrictedvisionperceptor).
struct VisionModel {
  PARAMETERS(VisionModel)
  PARAMETER(double, distanceShare, 0.000965, "", Range(0, 1), "of the distance, share of it")
  PARAMETER(double, distance, 0.0029, "m", Range(1e-6, 1), "of the distance, by rounding to a centimetre")
  PARAMETER(double, azimuth, 0.00258, "rad", Range(1e-6, 1), "of the azimuth (0.148 degrees)")
  PARAMETER(double, elevation, 0.00214, "rad", Range(1e-6, 1), "of the elevation (0.1225 degrees)")
  PARAMETER(double, offset, 0.0029, "m", Range(0, 1),
            "fixed offset of a connection, along each axis of the head")
  PARAMETER(double, tilt, 0.004, "rad", Range(0, 1), "of the estimated orientation of the head")
  PARAMETER(
      double, imageBorder, fromDegrees(59.4), "rad", Range(0.1, 1.5),
      "a line that ends so far to a side of the picture's middle is cut there (half the picture less four "
      "deviations of the angles)")
};

/// A seen point in the robot's ground frame (origin below the torso, x its heading).
struct GroundPoint {
  Vec2 position = Vec2::Zero();         ///< [m]
  Mat2 covariance = Mat2::Identity();   ///< [m^2]
  Mat2 information = Mat2::Identity();  ///< its inverse
  double height = 0;                    ///< above the ground [m]
};

/// The point at this distance [m], azimuth [rad, + left] and elevation [rad, + up] from the head.
GroundPoint projectToGround(double distance, double azimuth, double elevation, const Pose3& T_ground_head,
                            const VisionModel& noise);

/// Whether a polar point lies at the border of the picture, where lines are cut off. tangent: of
/// VisionModel::imageBorder, which is to each side in the planes of azimuth and of elevation.
bool atImageBorder(double azimuth, double elevation, double tangent);

struct SeenLandmark {
  int index = 0;  ///< of FieldMap
  GroundPoint point;
};

struct SeenFieldLine {
  GroundPoint a, b;
  bool aIsEnd = true, bIsEnd = true;  ///< the line ends there; else it was cut off by the picture's border
};

/// What one image shows of the field.
struct FieldView {
  std::vector<SeenLandmark> landmarks;
  std::vector<SeenFieldLine> lines;
};

}  // namespace plumbline
