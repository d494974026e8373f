#include "simulation/league/LeaguePhysics.h"

#include <optional>

#include "math/Gravity.h"
#include "simulation/effects/BodyEffects.h"
#include "simulation/effects/GroundEffects.h"
#include "simulation/league/FieldObstacles.h"

namespace plumbline::simulation {

namespace {

/// Values that a material asks for; of two that touch, the mean counts if both ask, else the one that does.
struct Wishes {
  std::optional<double> softErp, softCfm, slip, bounce;
  double bounceVelocity = 0;
};

double mix(std::optional<double> a, std::optional<double> b, double fallback) {
  if (a && b) return (*a + *b) / 2;
  return a ? *a : b.value_or(fallback);
}

ContactSurface mix(const Wishes& a, const Wishes& b, const PhysicsConfig& config) {
  ContactSurface surface;
  surface.softErp = mix(a.softErp, b.softErp, config.constraintErp);
  surface.softCfm = mix(a.softCfm, b.softCfm, config.constraintCfm);
  surface.slip = mix(a.slip, b.slip, 0);
  surface.bounce = mix(a.bounce, b.bounce, 0);
  const auto velocity = [](const Wishes& w) {
    return w.bounce ? std::optional(w.bounceVelocity) : std::nullopt;
  };
  surface.bounceVelocity = mix(velocity(a), velocity(b), 0);
  return surface;
}

}  // namespace

PhysicsConfig leaguePhysics(const WorldConfig& config) {
  PhysicsConfig physics;
  physics.stepSeconds = config.stepSeconds;
  physics.gravity = {0, 0, -earthGravity};
  physics.constraintErp = config.numbers.jointErp;
  physics.constraintCfm = config.numbers.jointCfm;
  physics.surfaceLayer = 0.001;
  physics.autoDisable = config.sleepingRobots;

  std::vector<Wishes> wishes(4);
  wishes[material::robot] = {0.6, 1e-4, 0.005, std::nullopt, 0};
  wishes[material::ball] = {0.5, 0.05, 0.6, 0.8, 0.8};
  // The ground asks for slip 0.1 and CFM 0.01, too, in calls that the server does not understand: its slip
  // stays at the default and its CFM undefined.
  wishes[material::ground] = {0.2, std::nullopt, 0.005, std::nullopt, 0};
  // Goals and walls set nothing and get the server's default handler.
  wishes[material::obstacle] = {std::nullopt, std::nullopt, std::nullopt, 0.8, 2.0};
  for (const Wishes& a : wishes) {
    auto& row = physics.surfaces.emplace_back();
    for (const Wishes& b : wishes) {
      row.push_back(mix(a, b, physics));
      if (!config.endlessFriction) row.back().friction = config.frictionCoefficient;
    }
  }
  for (const auto& [a, b] :
       {std::pair{material::robot, material::ground}, {material::ground, material::robot}}) {
    ContactSurface& surface = physics.surfaces[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)];
    surface.softErp = config.numbers.contactErp;
    surface.softCfm = config.numbers.contactCfm;
    surface.slip = config.numbers.contactSlip;
  }
  addGroundEffects(config.effects, material::ground, physics);
  return physics;
}

Assembly leagueRobot(const RobotModel& model, const WorldConfig& config) {
  Assembly assembly;
  assembly.selfCollision = config.selfCollision;
  std::vector<Vec3> origins;  // of the links, hinges at zero, in the root body's frame
  for (std::size_t i = 0; i < model.links.size(); ++i) {
    const Link& link = model.links[i];
    const bool isRoot = link.parent < 0;
    origins.push_back(isRoot ? Vec3(-link.com)
                             : Vec3(origins[static_cast<std::size_t>(link.parent)] + link.origin));

    BodySpec body;
    body.T_root_body = translation(isRoot ? Vec3(Vec3::Zero()) : Vec3(origins[i] + link.com));
    body.mass = link.mass;
    body.inertia = link.inertia;
    if (link.collides) {
      body.shape = link.shape;
      body.shape->T_link_shape = translation(-link.com) * link.shape.T_link_shape;
    }
    body.material = material::robot;
    body.linearDrag = body.angularDrag = config.numbers.drag;
    assembly.bodies.push_back(body);
    if (isRoot) continue;

    HingeSpec hinge;
    hinge.child = static_cast<int>(i);
    hinge.parent = link.parent;
    hinge.anchor = origins[i];
    hinge.axis = link.axis;
    hinge.lower = link.lower;
    hinge.upper = link.upper;
    hinge.maxTorque = motorTorque(config.numbers.motorTorque, link.joint, config.effects);
    hinge.cfm = hinge.stopCfm = 1e-8;
    hinge.stopErp = 0.8;
    hinge.stopBounce = config.bouncingJointStops ? 1 : 0;
    hinge.fudgeFactor = 1e-5;
    assembly.hinges.push_back(hinge);
  }
  return assembly;
}

Assembly leagueBall(const FieldSize& field) {
  BodySpec body;
  body.mass = ballMass;
  body.inertia = Mat3::Identity() * (0.4 * ballMass * field.ballRadius * field.ballRadius);
  body.shape.emplace();
  body.shape->kind = Shape::Kind::sphere;
  body.shape->size.x() = field.ballRadius;
  body.material = material::ball;
  body.linearDrag = 0.01;
  body.angularDrag = 5e-5;
  return {{body}, {}, false};
}

}  // namespace plumbline::simulation
