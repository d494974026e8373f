#include "modules/perception/PolarBallPerceptConverter.h"

#include <cmath>

namespace plumbline {

MAKE_MODULE(PolarBallPerceptConverter)

void PolarBallPerceptConverter::update(BallPercept* theBallPercept) {
  theBallPercept->seen = thePolarBallPercept->seen;
  if (!thePolarBallPercept->seen) return;
  const PolarPoint& polar = thePolarBallPercept->position;
  const double flat = polar.distance * std::cos(polar.elevation);
  const Vec3 inHead(flat * std::cos(polar.azimuth), flat * std::sin(polar.azimuth),
                    polar.distance * std::sin(polar.elevation));
  const Vec3 onGround = theTorsoPose->T_ground_torso * (theFKModel->T_torso_head * inHead);
  theBallPercept->position = onGround.head<2>();
  theBallPercept->height = onGround.z();
}

}  // namespace plumbline
