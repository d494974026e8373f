#pragma once
#include <Eigen/Core>
#include <memory>
#include <vector>

#include "gap/replay/CommandPath.h"
#include "gap/replay/Contacts.h"
#include "gap/replay/Plant.h"
#include "gap/replay/ServoLaw.h"
#include "gap/replay/SmallFactor.h"
#include "gap/replay/TreeDynamics.h"
#include "gap/replay/Trial.h"
#include "robot/DryFriction.h"
#include "robot/SupplyRail.h"

namespace plumbline::gap {

/// The state of a moving plant, and its time step. Coordinates: the tree's (base if free, then the chosen
/// joints), then one rotor for each joint whose gear has backlash or compliance. A copy with a fixed base is
/// independent; with a free base it would share its contacts.
class Stepper {
public:
  Stepper(const Plant& plant, const Trial& trial, const std::vector<int>& joints,
          const std::vector<std::uint8_t>* lostCycles);
  /// Changes which cycles' commands are lost from now on; the list must outlive this object. Null: unknown.
  void lose(const std::vector<std::uint8_t>* lostCycles);

  /// Sets the joints to their measured positions and the body so that the foot with the largest load is flat
  /// on the ground; place and heading stay. Backlash in gears stays on its side.
  void restart(const Restart& seen);

  bool geared() const { return !gears_.empty(); }
  void step(double from, double to);

  /// Reading of the encoder of the i-th chosen joint, and its speed; now and before the last step.
  double shown(int node) const { return drives_[index(node)].shown; }
  double rate(int node) const { return drives_[index(node)].rate; }
  double shownBefore(int node) const { return drives_[index(node)].shownBefore; }
  double rateBefore(int node) const { return drives_[index(node)].rateBefore; }
  double torque(int node) const { return drives_[index(node)].torque; }  ///< of the servo [N m]
  double torqueConstant(int node) const;  ///< of its motor [N m/A]; NaN if it is unknown
  /// What its motor draws from the supply: its current [A] times its duty, at this speed [rad/s].
  double supplyCurrent(int node, double current, double rate) const;
  /// Torque of its servo for the present command, this encoder angle and speed [N m].
  double torqueAt(int node, double shown, double rate) const;
  /// Duty of its servo for the present command and this encoder angle, see dutyOf().
  double duty(int node, double shown) const;
  /// Makes "before" equal "now".
  void hold();

  /// Readings of the whole robot: gyro, accelerometer, force sensors, true pose.
  void beginBody();
  void readBody(std::size_t cycle, double t, const std::vector<std::size_t>& signals,
                std::vector<std::vector<double>>& values);
  void endBody(const std::vector<std::size_t>& signals, std::vector<std::vector<double>>& values) const;
  bool fell() const { return hasFallen_; }

private:
  struct Drive {
    CommandPath path;
    const JointPlant* plant = nullptr;
    int joint = 0;
    int link = 0;    ///< coordinate of the link
    int motor = 0;   ///< coordinate of the rotor; the link's if the gear is rigid
    int sensed = 0;  ///< coordinate that the encoder measures
    double command = 0, armature = 0;
    ServoTerms terms = {};
    ServoLine line = {};
    double torque = 0, heat = 0;
    GearLoad load = {};  ///< load that presses the gear's teeth together
    double shown = 0, rate = 0, shownBefore = 0, rateBefore = 0;
  };
  struct Gear {
    int drive = 0;
    double stiffness = 0, damping = 0, play = 0;
    int side = 0;  ///< -1, 0, 1: which flank touches
  };
  struct Friction {
    int drive = 0, coordinate = 0;
    DryFriction bound = {};
    double force = 0;
    double mobility = 0;  ///< what one newton metre adds to its coordinate's velocity at the step's end
  };
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  void takeForces();
  ServoTerms::Given givenTo(const Drive& drive) const;
  DryFriction frictionBound(const Drive& drive) const;
  void assemble(double h);
  bool regimesHold(double h);
  void solve(double h);
  void bind(double h);
  double sweepFrictions(double* fresh);
  void advance(double h);
  void placeOnGround();
  void standOn(int foot);
  double heightOnGround() const;
  void sampleImu(double t);

  const Plant& plant_;
  const Trial& trial_;
  TreeDynamics tree_;
  std::vector<Drive> drives_;
  std::vector<Gear> gears_;
  std::vector<Gear> gearsUsed_;  ///< as the last solve had them; of step(), kept for its memory
  std::vector<Friction> frictions_;
  std::vector<const ExternalForce*> forces_;  ///< on links that move here
  std::shared_ptr<Contacts> contacts_;        ///< of a free base
  SupplyRail supply_;
  double weight_;  ///< weight of the new velocity in the motion of the step (1/2: midpoint)

  int n_ = 0;              ///< coordinates
  Eigen::VectorXd q_, v_;  ///< q has 0 for the base, whose pose is T
  Pose3 T_world_base_ = Pose3::Identity();
  Eigen::VectorXd qm_, u_, rhs_, force_, predicted_;
  Eigen::MatrixXd A_;
  SmallFactor factor_;
  // Of solve(), kept for their memory: velocity without frictions and contacts, what contacts add, what
  // each friction does (in columns); and both solved at once.
  Eigen::VectorXd unbound_, pushed_;
  Eigen::MatrixXd columns_;
  SmallFactor::Rows solved_;
  Eigen::VectorXd acceleration_;
  bool hasFallen_ = false;
  // Readings of the IMU: per cycle, or after every step if it is late. Commands change once a cycle, and the
  // torso feels it, so between two cycles its acceleration is not on a line.
  bool imuIsLate_ = false;
  std::vector<double> cycleTime_, imuTime_;
  std::vector<Vec3> gyro_, specificForce_;
};

}  // namespace plumbline::gap
