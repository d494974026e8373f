#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "field/FieldMarks.h"
#include "math/Types.h"
#include "simspark/ServerMessage.h"
#include "simulation/world/RandomStream.h"

namespace plumbline::simulation {

/// Measurement error of the league's camera (restrictedvisionperceptor).
struct CameraError {
  double distancePercent = 0.0965;                   ///< standard deviation [% of the distance]
  double azimuth = 0.1480 * 0.017453292519943295;    ///< [rad]
  double elevation = 0.1225 * 0.017453292519943295;  ///< [rad]
  double offset =
      0.005;  ///< the same error of position in every image of a connection: at most, per axis [m]
  static CameraError none() { return {0, 0, 0, 0}; }
};

/// What can be seen, in the world frame.
struct VisibleWorld {
  struct Part {
    std::string_view name;  ///< head rlowerarm llowerarm rfoot lfoot
    Vec3 position;
  };
  struct Player {
    std::string_view team;
    int unum = 0;
    std::vector<Part> parts;
  };
  FieldMarks marks;
  Vec3 ball = Vec3::Zero();
  std::vector<Player> players;
};

/// The restricted camera of the league's robots. It looks along x of the head, 60 degrees to each side and up
/// and down. It sees nothing nearer than 0.1 m, and sees through everything, also its own arms.
class Vision {
public:
  explicit Vision(const CameraError& noise, RandomStream& random);

  simspark::See see(const Pose3& T_world_head, const VisibleWorld& world);

private:
  bool look(const Vec3& world, const Pose3& T_head_world, simspark::Polar& seen);
  void addNoise(simspark::Polar& polar);

  CameraError noise_;
  RandomStream& random_;
  Vec3 offset_ = Vec3::Zero();  ///< constant error in the head frame [m]
};

/// Clips a line in head coordinates to the camera's image, as the league's server does. A line with both ends
/// in the cone of view stays whole. Otherwise it is clipped at the near plane x = 0.1 m and at the edges of
/// the square image. False: nothing is seen of it. The server's errors are reproduced. The cone is round and
/// the image is square, so a line whose only visible end lies outside of the image disappears. By rounding, a
/// quarter of the lines that leave the image at the top or bottom disappear too.
bool clipToView(Vec3& a, Vec3& b);

}  // namespace plumbline::simulation
