// What limits a kick: build/bench/kick-limit.json and .md. How fast a ball must leave to come so far, how
// fast a robot can move its foot at most, and what the long kicks reach of that.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <vector>

#include "Contact.h"
#include "FastestFoot.h"
#include "framework/WriteFile.h"
#include "math/Angle.h"
#include "simspark/LeagueRobots.h"
#include "training/tasks/BallRoll.h"

namespace {

using namespace plumbline;
using namespace plumbline::bench;

/// How far a ball comes that leaves the ground with this speed and elevation, without spin [m].
double reach(training::BallRoll& roll, double speed, double elevation) {
  simulation::BodyState ball;
  ball.pose.translation() = Vec3(-14, 0, simulation::WorldConfig().field.ballRadius);
  ball.linearVelocity = Vec3(speed * std::cos(elevation), 0, speed * std::sin(elevation));
  return roll.roll(ball).x() + 14;
}

struct Launch {
  double speed = 0, elevation = 0;  // [m/s, deg]
};

/// The slowest ball that comes so far.
Launch slowest(training::BallRoll& roll, double distance) {
  Launch best{1e9, 0};
  for (int degrees = 0; degrees <= 60; degrees += 5) {
    double low = 0, high = 20;
    for (int i = 0; i < 12; ++i) {
      const double middle = (low + high) / 2;
      (reach(roll, middle, fromDegrees(degrees)) < distance ? low : high) = middle;
    }
    if (high < best.speed) best = {high, static_cast<double>(degrees)};
  }
  return best;
}

/// How far a kick's ball comes if all its velocities are `factor` times as large [m].
double reach(training::BallRoll& roll, const Contact& contact, double factor) {
  simulation::BodyState ball = contact.ball;
  ball.linearVelocity *= factor;
  ball.angularVelocity *= factor;
  return (roll.roll(ball) - contact.from).norm();
}

/// How far it comes at the best of all elevations, with the same speed and spin [m].
double bestReach(training::BallRoll& roll, Contact contact) {
  const Vec3 v = contact.ball.linearVelocity;
  const Vec2 forward = v.head<2>().normalized();
  double best = 0;
  for (int degrees = 0; degrees <= 60; degrees += 5) {
    const double elevation = fromDegrees(degrees), along = v.norm() * std::cos(elevation);
    contact.ball.linearVelocity =
        Vec3(along * forward.x(), along * forward.y(), v.norm() * std::sin(elevation));
    best = std::max(best, reach(roll, contact, 1));
  }
  return best;
}

/// By what its velocities must grow for that distance.
double factorFor(training::BallRoll& roll, const Contact& contact, double distance) {
  double low = 0.5, high = 4;
  for (int i = 0; i < 12; ++i) {
    const double middle = (low + high) / 2;
    (reach(roll, contact, middle) < distance ? low : high) = middle;
  }
  return high;
}

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values.empty() ? 0 : values[values.size() / 2];
}

}  // namespace

int main(int argc, char** argv) {
  const int tries = argc > 1 ? std::atoi(argv[1]) : 200;
  constexpr int starts = 100;
  constexpr double spread = 0.01;
  training::BallRoll roll;
  std::string json, text = fmt::format(
                        "## How fast a ball must be\n\nThe slowest ball, without spin, that leaves the "
                        "ground and comes so far before it rests, at the "
                        "elevation that is best\nof 0, 5, ... 60 degrees; the league's physics.\n\n"
                        "| distance [m] | speed [m/s] | elevation [deg] |\n|---|---|---|\n");
  const auto figure = [&](const std::string& name, double value, const char* unit) {
    json += fmt::format("{}  {{\"name\": \"kick-limit.{}\", \"value\": {:.4g}, \"unit\": \"{}\"}}",
                        json.empty() ? "[\n" : ",\n", name, value, unit);
  };
  for (const int distance : {6, 8, 10, 12, 14}) {
    const Launch launch = slowest(roll, distance);
    text += fmt::format("| {} | {:.2f} | {:.0f} |\n", distance, launch.speed, launch.elevation);
    figure(fmt::format("speed_for_{}_m", distance), launch.speed, "m/s");
  }
  text += fmt::format(
      "\n## How fast a foot can be, and is\n\n"
      "Both legs: no posture moves the front of the right foot forward faster, with all joints of both legs "
      "at their speed limits\n"
      "and the left foot flat on the ground ({} random starts of a search). Right leg: with the joints of "
      "the right leg alone. Torques,\n"
      "inertia and the way that it takes to become so fast are not in these bounds. Foot, ball, topspin, "
      "distance: medians of {} long\n"
      "kicks each, seeds from 1, ball within {:.0f} mm. Foot: its point next to the ball when they meet. At "
      "limit: pitch joints of the\n"
      "kicking leg within 5 % of their speed limit then. Best: the same ball at the best "
      "elevation of 0, 5, ... 60 degrees.\nNeeded: the foot's speed for 14 m, if all velocities of the ball "
      "grow with it.\n\n"
      "| type | both legs [m/s] | right leg [m/s] | foot [m/s] | ball [m/s] | ball / foot | elevation [deg] "
      "| topspin [rad/s] | at limit [%] "
      "| distance [m] | best [m] | needed [m/s] |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n",
      starts, tries, 1e3 * spread);
  for (int type = 0; type < numSimsparkTypes(); ++type) {
    training::MotionTrial trial(type);
    const FastestFoot fastest = fastestFoot(trial.model, starts, 1);
    std::vector<double> foot, speed, elevation, spin, ratio, distance, highest, factor;
    double atLimit = 0;
    for (int i = 0; i < tries; ++i) {
      const Contact contact = kickContact(trial, "kickLong", spread, static_cast<unsigned>(1 + i));
      if (!contact.touched || contact.foot <= 0) continue;
      const Vec3 v = contact.ball.linearVelocity;
      foot.push_back(contact.foot);
      speed.push_back(v.norm());
      elevation.push_back(toDegrees(std::asin(v.z() / v.norm())));
      // About the axis to the left of the ball's way: positive if the top moves forward.
      spin.push_back(contact.ball.angularVelocity.dot(Vec3(-v.y(), v.x(), 0).normalized()));
      ratio.push_back(v.norm() / contact.foot);
      distance.push_back(reach(roll, contact, 1));
      highest.push_back(bestReach(roll, contact));
      factor.push_back(factorFor(roll, contact, 14));
      atLimit += 100 * contact.joints / tries;
    }
    const double needed = median(factor) * median(foot);
    text += fmt::format(
        "| {} | {:.1f} | {:.1f} | {:.2f} | {:.2f} | {:.2f} | {:.0f} | {:.0f} | {:.0f} | {:.1f} | {:.1f} | "
        "{:.1f} |\n",
        type, fastest.wholeChain, fastest.kickingLeg, median(foot), median(speed), median(ratio),
        median(elevation), median(spin), atLimit, median(distance), median(highest), needed);
    figure(fmt::format("type{}.both_legs", type), fastest.wholeChain, "m/s");
    figure(fmt::format("type{}.right_leg", type), fastest.kickingLeg, "m/s");
    figure(fmt::format("type{}.foot", type), median(foot), "m/s");
    figure(fmt::format("type{}.ball", type), median(speed), "m/s");
    figure(fmt::format("type{}.foot_needed_for_14_m", type), needed, "m/s");
    std::fprintf(stderr, "type %d: %d kicks, %zu of them touched the ball\n", type, tries, foot.size());
  }
  writeFile("build/bench/kick-limit.json", json + "\n]\n");
  writeFile("build/bench/kick-limit.md", text);
  std::fputs(text.c_str(), stdout);
  return 0;
}
