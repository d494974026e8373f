#include "support/SyntheticImage.h"

#include <cmath>

#include "math/Angle.h"
#include "math/Pose2.h"
#include "modules/modeling/selflocator/FieldMap.h"

namespace plumbline::test {
namespace {

constexpr double halfView = fromDegrees(60);

bool inView(const Vec3& p) {
  const double distance = p.norm();
  return distance > 0.1 && std::abs(std::atan2(p.y(), p.x())) <= halfView &&
         std::abs(std::asin(p.z() / distance)) <= halfView;
}

/// Cuts the segment to the four planes of the view; false if nothing is left.
bool clip(Vec3& a, Vec3& b) {
  const double t = std::tan(halfView);
  const Vec3 planes[] = {{t, -1, 0}, {t, 1, 0}, {t, 0, -1}, {t, 0, 1}};
  double from = 0, to = 1;
  for (const Vec3& inside : planes) {
    const double da = inside.dot(a), db = inside.dot(b);
    if (da < 0 && db < 0) return false;
    if (da < 0) from = std::max(from, da / (da - db));
    if (db < 0) to = std::min(to, da / (da - db));
  }
  if (from >= to) return false;
  const Vec3 d = b - a;
  b = a + to * d;
  a += from * d;
  return true;
}

double rounded(double value, double step) { return std::round(value / step) * step; }

}  // namespace

SyntheticImage::SyntheticImage(std::uint64_t seed) : random_(seed), noisy_(true) {
  for (int i = 0; i < 3; ++i) offset_[i] = random_.uniform(-0.005, 0.005);
}

simspark::Polar SyntheticImage::measure(const Vec3& pointInHead) {
  const Vec3 p = pointInHead + offset_;
  simspark::Polar polar;
  polar.distance = p.norm();
  polar.azimuth = std::atan2(p.y(), p.x());
  polar.elevation = std::asin(p.z() / polar.distance);
  if (!noisy_) return polar;
  polar.distance = rounded(polar.distance * (1 + 0.000965 * random_.gaussian()), 0.01);
  polar.azimuth = rounded(polar.azimuth + fromDegrees(0.1480) * random_.gaussian(), fromDegrees(0.01));
  polar.elevation = rounded(polar.elevation + fromDegrees(0.1225) * random_.gaussian(), fromDegrees(0.01));
  return polar;
}

simspark::See SyntheticImage::see(const Pose3& T_field_head, const Vec3& ball) {
  const Pose3 T_head_field = T_field_head.inverse();
  const FieldMap map(FieldSize{}, true);
  simspark::See see;
  for (const char* name : {"F1L", "F2L", "F1R", "F2R", "G1L", "G2L", "G1R", "G2R"}) {
    const Vec2 place = map.landmark(FieldMap::landmarkIndex(name));
    const Vec3 p = T_head_field * Vec3(place.x(), place.y(), name[0] == 'G' ? 0.8 : 0.0);
    if (inView(p)) see.objects.push_back({name, measure(p)});
  }
  const Vec3 ballInHead = T_head_field * ball;
  if (inView(ballInHead)) see.objects.push_back({"B", measure(ballInHead)});
  for (const FieldSegment& segment : map.segments()) {
    const Vec2 end = segment.start + segment.length * segment.direction;
    Vec3 a = T_head_field * Vec3(segment.start.x(), segment.start.y(), 0);
    Vec3 b = T_head_field * Vec3(end.x(), end.y(), 0);
    if (clip(a, b)) see.lines.push_back({measure(a), measure(b)});
  }
  return see;
}

Pose3 headOverGround(double headYaw, double headPitch, double height) {
  return translation(0, 0, height) * rotationZ(headYaw) * rotationY(headPitch);
}

Pose3 onField(const Pose2& place) { return translation(place.x(), place.y(), 0) * rotationZ(place.heading); }

FieldView fieldView(const simspark::See& see, const Pose3& T_ground_head, const VisionModel& noise) {
  FieldView view;
  const auto project = [&](const simspark::Polar& p) {
    return projectToGround(p.distance, p.azimuth, p.elevation, T_ground_head, noise);
  };
  for (const simspark::SeenObject& object : see.objects) {
    const int index = FieldMap::landmarkIndex(object.name);
    if (index >= 0) view.landmarks.push_back({index, project(object.position)});
  }
  const double border = std::tan(noise.imageBorder);
  for (const simspark::SeenLine& line : see.lines)
    view.lines.push_back({project(line.a), project(line.b),
                          !atImageBorder(line.a.azimuth, line.a.elevation, border),
                          !atImageBorder(line.b.azimuth, line.b.elevation, border)});
  return view;
}

}  // namespace plumbline::test
