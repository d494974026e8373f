#include "training/WalkTrial.h"

#include "math/Random.h"
#include "training/LeanWatch.h"

namespace plumbline::training {
namespace {

/// Any request within the walk's limits, in one case of four full speed ahead, in one a turn on the spot, in
/// some a stop.
walking::WalkRequest anyRequest(Random& random, const walking::WalkParameters& p) {
  walking::WalkRequest request;
  request.walk = random.uniform() > 0.15;
  request.velocity = Vec2(random.uniform(-p.speed.maxBackward, p.speed.maxForward),
                          random.uniform(-p.speed.maxSideways, p.speed.maxSideways));
  request.turn = random.uniform(-p.speed.maxTurn, p.speed.maxTurn);
  const double kind = random.uniform(0, 4);
  if (kind < 1) {
    request.velocity = Vec2(p.speed.maxForward, 0);
    request.turn *= 0.2;
  } else if (kind < 2) {
    request.velocity.setZero();
  }
  return request;
}

/// Full speed with little else.
walking::WalkRequest nearly(walking::WalkRequest full, Random& random, const walking::WalkParameters& p) {
  const auto some = [&](double most) { return random.uniform(-0.15, 0.15) * most; };
  full.velocity += Vec2(full.velocity.x() == 0 ? some(p.speed.maxForward) : 0,
                        full.velocity.y() == 0 ? some(p.speed.maxSideways) : 0);
  if (full.turn == 0) full.turn = some(p.speed.maxTurn);
  return full;
}

class Try {
public:
  Try(Walker& robot, Random& random, double push) : robot_(robot), random_(random), push_(push) {}

  bool step(const walking::WalkRequest& request) {
    if (push_ > 0 && random_.uniform() < robot_.cycle) {
      const double direction = random_.uniform(-pi, pi), size = random_.uniform(0, push_);
      robot_.push(size * Vec3(std::cos(direction), std::sin(direction), 0));
    }
    const bool upright = robot_.step(request);
    lean_.look(robot_.torso(), robot_.cycle);
    return upright;
  }
  bool run(const walking::WalkRequest& request, double seconds) {
    double t = 0;
    while (t < seconds) {
      if (!step(request)) return false;
      t += robot_.cycle;
    }
    return true;
  }
  double lean() const { return lean_.greatest(); }

private:
  Walker& robot_;
  Random& random_;
  double push_;
  LeanWatch lean_;
};

constexpr double leanOfFall = 1;  // [rad]

/// One try in one direction; false if it ended in a fall.
bool tryDirection(Walker& robot, Random& random, const walking::WalkParameters& p, WalkTrialKind task,
                  const WalkTrialSetup& setup, WalkTrialResult& result) {
  Try attempt(robot, random, setup.push);
  result.lean += leanOfFall / setup.tries;  // until it has come to its end
  robot.restart(Pose2(-14, 5));             // clear of goals and walls
  const double sign = random.uniform() < 0.5 ? -1 : 1;
  const walking::WalkRequest full = fullSpeed(task, sign);
  if (!attempt.run({}, random.uniform(0.1, 0.5))) return false;
  if (!attempt.run(full, 1.2)) return false;
  double along = 0, across = 0, time = 0;
  bool upright = true;
  for (double t = 1.2; upright && t < setup.seconds;) {
    // Full speed, then something else for a while.
    const auto go = [&](const walking::WalkRequest& request, double duration, bool counts) {
      const double end = std::min(setup.seconds, t + duration), turned = robot.turned();
      Vec2 way = Vec2::Zero();
      const double begin = t;
      for (; upright && t < end; t += robot.cycle) {
        upright = attempt.step(request);
        way += robot.moved.position;
        const Pose2 place = robot.pose();
        if (std::abs(place.x()) > 14.5 || std::abs(place.y()) > 9) robot.carry(Vec2(0, 5));
      }
      if (!counts) return;
      time += t - begin;
      const Vec2 direction = full.velocity.normalized();
      along += task == WalkTrialKind::turn ? (robot.turned() - turned) * sign : direction.dot(way);
      across +=
          task == WalkTrialKind::turn ? way.norm() : std::abs(Vec2(-direction.y(), direction.x()).dot(way));
    };
    go(full, random.uniform(1, 3), true);
    if (random.uniform() < 0.5) go(anyRequest(random, p), random.uniform(0.3, 1), false);
    if (random.uniform() < 0.5) go(nearly(full, random, p), random.uniform(0.3, 1), true);
  }
  if (time > 0 && upright) {
    result.speed += along / time / setup.tries;
    result.drift += across / time / setup.tries;
  }
  if (!upright || !attempt.run({}, 2) || !robot.output.standing) return false;
  result.lean += (std::min(leanOfFall, attempt.lean()) - leanOfFall) / setup.tries;
  return true;
}

/// The same with the sprint cut to a share that the seed draws; its lean is added to the result's.
void tryCutSprint(Walker& robot, const walking::WalkGaits& gaits, std::uint64_t seed, WalkTrialKind task,
                  const WalkTrialSetup& setup, WalkTrialResult& result) {
  constexpr double leastShare = 0.45;  // of the way from the omnidirectional speed to full speed
  constexpr double ofSeconds = 0.6;    // share of a whole try's length
  Random random(~seed);
  const walking::WalkGaits cut = cutSprint(gaits, task, random.uniform(leastShare, 1));
  robot.use(cut);
  WalkTrialSetup shorter = setup;
  shorter.seconds *= ofSeconds;
  WalkTrialResult of;
  tryDirection(robot, random, cut.base, task, shorter, of);
  result.lean += of.lean;
  robot.use(gaits);
}

WalkTrialResult tryMixture(Walker& robot, const walking::WalkParameters& p, const WalkTrialSetup& setup) {
  WalkTrialResult result;
  const double minutes = setup.tries * setup.seconds / 60;
  Random random(setup.seed);
  Try attempt(robot, random, setup.push);
  robot.restart();
  double time = 0, wanted = 0, got = 0, length = 0, miss = 0;
  int falls = 0;
  while (time < 60 * minutes) {
    const walking::WalkRequest request = anyRequest(random, p);
    const double duration = random.uniform(0.3, 2);
    time += duration;
    Pose2 walked, estimated;
    bool upright = true;
    for (double t = 0; upright && t < duration; t += robot.cycle) {
      upright = attempt.step(request);
      walked = walked * robot.moved;
      estimated = estimated * robot.output.odometry;
    }
    if (request.walk && request.velocity.norm() > 0.05) {
      wanted += request.velocity.norm() * duration;
      if (upright)
        got += Eigen::Rotation2Dd(walked.heading / 2)
                   .inverse()
                   .
                   operator*(walked.position)
                   .dot(request.velocity.normalized());
    }
    length += walked.position.norm();
    miss += (estimated.position - walked.position).norm();
    if (!upright) {
      ++falls;
      if (setup.stopEarly && falls >= 6 && falls > 6 * time / 60) {
        falls = static_cast<int>(falls * 60 * minutes / time);
        break;
      }
    }
    if (!upright || robot.pose().position.norm() > 8) robot.restart();
  }
  result.falls = falls / minutes;
  result.odometry = length > 0 ? miss / length : 0;
  result.speed = wanted > 0 ? got / wanted : 0;
  return result;
}

/// One push of 0.1 s while standing, stepping or walking, from anywhere; falls count the more the smaller it
/// was, the hardest by half as much as the mean.
WalkTrialResult tryPushes(Walker& robot, const walking::WalkParameters& p, const WalkTrialSetup& setup) {
  WalkTrialResult result;
  for (int i = 0; i < setup.tries; ++i) {
    Random random(setup.seed * 1000 + static_cast<std::uint64_t>(i));
    walking::WalkRequest request;
    if (i % 3 == 1) request = {Vec2::Zero(), 0, true};
    if (i % 3 == 2) {
      request = random.uniform() < 0.5 ? walking::WalkRequest{Vec2(0.3, 0), 0, true} : anyRequest(random, p);
      request.walk = true;
    }
    const double share = (i + random.uniform()) / setup.tries, direction = random.uniform(-pi, pi);
    const auto cycles = static_cast<int>(std::lround(0.1 / robot.cycle));
    const double change = setup.push * share / cycles;
    robot.restart();
    bool upright = robot.run({}, 0.3) && robot.run(request, random.uniform(1.5, 2.2));
    for (int j = 0; upright && j < cycles; ++j) {
      robot.push(change * Vec3(std::cos(direction), std::sin(direction), 0));
      upright = robot.step(request);
    }
    if (!upright || !robot.run(request, 3)) result.falls += (1.5 - share) / setup.tries;
  }
  return result;
}

}  // namespace

walking::WalkRequest fullSpeed(WalkTrialKind task, double sign) {
  constexpr double enough = 9;
  switch (task) {
    case WalkTrialKind::forward:
      return {Vec2(enough, 0), 0, true};
    case WalkTrialKind::backward:
      return {Vec2(-enough, 0), 0, true};
    case WalkTrialKind::sideways:
      return {Vec2(0, sign * enough), 0, true};
    case WalkTrialKind::turn:
    case WalkTrialKind::mixture:
    case WalkTrialKind::push:
      return {Vec2::Zero(), sign * enough, true};
  }
  return {};
}

HeldSpeed holdSpeed(Walker& robot, const walking::WalkRequest& request, double seconds, double wait,
                    double aside) {
  HeldSpeed result;
  const Vec2 direction = request.velocity.normalized();
  Vec2 begin(-14.5, 5 - aside);
  if (!robot.carries() && direction.x() < 0) begin.x() = 14.5;
  if (!robot.carries() && direction.y() != 0) begin.y() = -9 * direction.y() - aside;
  double before = 0, way = 0, turned = 0, time = 0;
  const auto setOff = [&] {
    robot.restart(Pose2(begin));
    const bool upright = robot.run({}, wait) && robot.run(request, 2);
    before = robot.turned();
    return upright;
  };
  result.upright = setOff();
  for (; result.upright && time < seconds; time += robot.cycle) {
    result.upright = robot.step(request);
    way += robot.moved.position.dot(direction);
    if (std::abs(robot.pose().x()) < 14.8 && std::abs(robot.pose().y()) < 9.5) continue;
    // A field is 30 m long; back to its beginning, the posture as it is where that can be done.
    if (robot.carries()) {
      robot.carry(Vec2(0, 0));
    } else if (result.upright) {
      turned += robot.turned() - before;
      result.upright = setOff();
    }
  }
  turned += robot.turned() - before;
  if (time > 0) result.speed = (request.turn != 0 ? std::abs(turned) : way) / time;
  return result;
}

WalkTrialResult tryWalk(Walker& robot, const walking::WalkGaits& gaits, WalkTrialKind task,
                        const WalkTrialSetup& setup) {
  robot.use(gaits);
  if (task == WalkTrialKind::mixture) return tryMixture(robot, gaits.base, setup);
  if (task == WalkTrialKind::push) return tryPushes(robot, gaits.base, setup);
  WalkTrialResult result;
  int fallen = 0;
  for (int i = 0; i < setup.tries; ++i) {
    const std::uint64_t seed = setup.seed * 1000 + static_cast<std::uint64_t>(i);
    Random random(seed);
    if (!tryDirection(robot, random, gaits.base, task, setup, result)) ++fallen;
    if (setup.alsoCut) tryCutSprint(robot, gaits, seed, task, setup, result);
    if (setup.stopEarly && i == 2 && fallen == 3) {
      fallen = setup.tries;
      result.lean = leanOfFall * (setup.alsoCut ? 2 : 1);
      break;
    }
  }
  result.falls = static_cast<double>(fallen) / setup.tries;
  return result;
}

}  // namespace plumbline::training
