#include "simulation/sensors/Vision.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "field/FieldMarks.h"
#include "math/Angle.h"
#include "simspark/ServerMessageParser.h"
#include "support/Samples.h"

namespace plumbline::simulation {
namespace {

Pose3 standing(double x, double y, double heading) { return translation(x, y, 0.54) * rotationZ(heading); }

TEST(Vision, seesWhatIsInTheConeInTheServersOrder) {
  RandomStream random(1);
  Vision vision(CameraError::none(), random);
  const auto image = vision.see(standing(0, 0, 0), {});
  std::string names;
  for (const auto& object : image.objects) names += object.name + ' ';
  EXPECT_EQ(names, "G2R G1R F1R F2R ") << "the ball lies between the feet, more than 60 degrees down";
  EXPECT_NEAR(image.objects[1].position.azimuth, std::atan2(1.05, 15), 1e-12);
  EXPECT_NEAR(image.objects[1].position.elevation, std::atan2(0.26, std::hypot(15, 1.05)), 1e-12);
  EXPECT_NEAR(image.objects[2].position.distance, std::sqrt(225 + 100 + 0.54 * 0.54), 1e-12);
  EXPECT_EQ(vision.see(standing(0, 0, pi), {}).objects[0].name, "G1L");
}

TEST(Vision, nothingNearerThanTenCentimetresButThroughEverything) {
  RandomStream random(1);
  Vision vision(CameraError::none(), random);
  VisibleWorld world;
  world.ball = Vec3(0.09, 0, 0.54);
  const auto sees = [&] {
    const auto image = vision.see(standing(0, 0, 0), world);
    return image.objects.back().name == "B";
  };
  EXPECT_FALSE(sees());
  world.ball.x() = 0.11;
  EXPECT_TRUE(sees());
  world.ball = Vec3(1, std::tan(fromDegrees(60.5)), 0.54);
  EXPECT_FALSE(sees());
  world.ball = Vec3(1, std::tan(fromDegrees(59.5)), 0.54);
  EXPECT_TRUE(sees());
  world.ball = Vec3(1, 0, 0.54 + std::tan(fromDegrees(60.5)));
  EXPECT_FALSE(sees());
}

TEST(Vision, playersByTheirVisibleParts) {
  RandomStream random(1);
  Vision vision(CameraError::none(), random);
  VisibleWorld world;
  world.players.push_back(
      {"A", 3, {{"head", Vec3(2, 0, 0.54)}, {"rfoot", Vec3(-1, 0, 0)}, {"lfoot", Vec3(2, 0.1, 0)}}});
  world.players.push_back({"B", 4, {{"head", Vec3(-2, 0, 0.54)}}});
  const auto image = vision.see(standing(0, 0, 0), world);
  ASSERT_EQ(image.players.size(), 1u);
  EXPECT_EQ(image.players[0].team, "A");
  EXPECT_EQ(image.players[0].unum, 3);
  ASSERT_EQ(image.players[0].parts.size(), 2u);
  EXPECT_EQ(image.players[0].parts[1].name, "lfoot");
}

TEST(Vision, noiseAsMeasuredOnTheLeaguesServer) {
  VisibleWorld world;
  world.ball = Vec3(10, 0, 0.54);
  double offsetSquares = 0;
  for (std::uint64_t connection = 1; connection <= 40; ++connection) {
    RandomStream random(9, connection);
    Vision vision(CameraError{}, random);
    const int n = 600;
    double sum[3] = {}, squares[3] = {};
    for (int i = 0; i < n; ++i) {
      const auto image = vision.see(standing(0, 0, 0), world);
      const auto& p = image.objects.back().position;
      const double values[3] = {p.distance, p.azimuth, p.elevation};
      for (int k = 0; k < 3; ++k) {
        sum[k] += values[k] / n;
        squares[k] += values[k] * values[k] / n;
      }
    }
    const double sigma[3] = {0.000965 * 10, fromDegrees(0.148), fromDegrees(0.1225)};
    const double truth[3] = {10, 0, 0};
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(std::sqrt(squares[k] - sum[k] * sum[k]), sigma[k], 0.15 * sigma[k]);
      const double scale = k == 0 ? 1 : 10;  // an angle times the distance is a length
      EXPECT_LT(std::fabs(sum[k] - truth[k]) * scale, 0.005 + 4 * sigma[k] * scale / std::sqrt(n));
      offsetSquares += std::pow((sum[k] - truth[k]) * scale, 2);
    }
  }
  EXPECT_NEAR(std::sqrt(offsetSquares / 120), 0.005 / std::sqrt(3), 0.0009)
      << "uniform within 5 mm, fixed per connection";
}

TEST(Vision, linesAreClippedToTheView) {
  const double t = std::tan(fromDegrees(60));
  Vec3 a(5, 1, 0), b(5, -1, 0);
  EXPECT_TRUE(clipToView(a, b));
  EXPECT_EQ(a, Vec3(5, 1, 0)) << "all inside: as it is";

  a = Vec3(5, 0, -1), b = Vec3(5, 100, -1);
  EXPECT_TRUE(clipToView(a, b));
  EXPECT_EQ(a, Vec3(5, 0, -1));
  EXPECT_LT((b - Vec3(5, 5 * t, -1)).norm(), 1e-9) << "at the left edge";

  a = Vec3(-5, 0, -1), b = Vec3(5, 0, -1);
  EXPECT_TRUE(clipToView(a, b));
  EXPECT_LT((a - Vec3(1 / t, 0, -1)).norm(), 1e-9) << "coming from behind: at the lower edge";

  a = Vec3(5, -100, -1), b = Vec3(5, 100, -1);
  EXPECT_TRUE(clipToView(a, b));
  EXPECT_LT((a - Vec3(5, 5 * t, -1)).norm() + (b - Vec3(5, -5 * t, -1)).norm(), 1e-9)
      << "cut on both sides it begins left";

  a = Vec3(-5, 1, -1), b = Vec3(-5, -1, -1);
  EXPECT_FALSE(clipToView(a, b));
  a = Vec3(1, 10, -1), b = Vec3(2, 20, -1);
  EXPECT_FALSE(clipToView(a, b));
  a = Vec3(0.01, 0, -1), b = Vec3(0.05, 0, -1);
  EXPECT_FALSE(clipToView(a, b)) << "below the feet";
}

// On the league's server a new robot is put to one of a row of places and hangs there for a cycle. So its
// head's place is known to the millimetre, and its percepts can be compared point by point.
class SeenByTheLeague : public testing::TestWithParam<int> {};

TEST_P(SeenByTheLeague, sameListOfThingsAtTheSamePlaces) {
  const auto messages = test::samples("agent_type" + std::to_string(GetParam()));
  simspark::ServerMessage recorded;
  ASSERT_FALSE(simspark::parseServerMessage(messages[2], recorded));
  ASSERT_TRUE(recorded.see);
  ASSERT_EQ(recorded.see->objects[0].name, "G2R");
  const double y = -1.05 + 29.2 * std::tan(-recorded.see->objects[0].position.azimuth);
  const double place = 9.2 - 1.2 * std::round((9.2 - y) / 1.2);
  ASSERT_NEAR(y, place, 0.3);

  VisibleWorld world;
  world.ball = Vec3(0, 0, 0.042);
  RandomStream random(1);
  const double torsoHeight = 0.4 - 0.5 * 9.81 * 0.02 * 0.02;
  const auto image =
      Vision(CameraError::none(), random).see(translation(-14.2, place, torsoHeight + 0.155), world);

  const double angle = 5 * fromDegrees(0.148) + 0.005 / 1.0;  // noise, and the offset seen from a metre away
  ASSERT_EQ(image.objects.size(), recorded.see->objects.size());
  for (std::size_t i = 0; i < image.objects.size(); ++i) {
    const auto &ours = image.objects[i], &theirs = recorded.see->objects[i];
    EXPECT_EQ(ours.name, theirs.name);
    EXPECT_NEAR(ours.position.distance, theirs.position.distance, 0.01 + 0.005 * ours.position.distance)
        << ours.name;
    EXPECT_NEAR(ours.position.azimuth, theirs.position.azimuth, angle) << ours.name;
    EXPECT_NEAR(ours.position.elevation, theirs.position.elevation, angle) << ours.name;
  }
  // A line that leaves the image above or below may be missing on either side, by the server's rounding.
  const auto near = [&](const simspark::Polar& ours, const simspark::Polar& theirs) {
    return std::fabs(ours.distance - theirs.distance) < 0.02 + 0.005 * ours.distance &&
           std::fabs(ours.azimuth - theirs.azimuth) < angle &&
           std::fabs(ours.elevation - theirs.elevation) < angle;
  };
  std::size_t matched = 0;
  for (const auto& line : image.lines) {
    const bool same = matched < recorded.see->lines.size() && near(line.a, recorded.see->lines[matched].a) &&
                      near(line.b, recorded.see->lines[matched].b);
    const double lowerEnd = std::tan(line.b.elevation) / std::cos(line.b.azimuth);
    EXPECT_TRUE(same || lowerEnd < -1.73)
        << "line to " << line.b.distance << ' ' << toDegrees(line.b.azimuth);
    matched += same;
  }
  EXPECT_EQ(matched, recorded.see->lines.size());
}
INSTANTIATE_TEST_SUITE_P(Types, SeenByTheLeague, testing::Range(0, 5));

}  // namespace
}  // namespace plumbline::simulation
