#pragma once
#include <memory>
#include <string>

#include "dds/RosSender.h"
#include "framework/Module.h"
#include "representations/infrastructure/FrameInfo.h"
#include "representations/infrastructure/JointData.h"
#include "representations/infrastructure/RobotDescription.h"
#include "representations/infrastructure/SensorData.h"
#include "representations/modeling/BallPos.h"
#include "representations/modeling/FKModel.h"
#include "representations/modeling/Odometry.h"
#include "representations/modeling/RobotPose.h"
#include "representations/modeling/TorsoPose.h"

namespace plumbline {

MODULE(RosBridge)
  REQUIRES(FrameInfo)
  REQUIRES_IF_PROVIDED(JointData)
  REQUIRES_IF_PROVIDED(SensorData)
  REQUIRES_IF_PROVIDED(RobotDescription)
  REQUIRES_IF_PROVIDED(Odometry)
  REQUIRES_IF_PROVIDED(TorsoPose)
  REQUIRES_IF_PROVIDED(FKModel)
  REQUIRES_IF_PROVIDED(RobotPose)
  REQUIRES_IF_PROVIDED(BallPos)
  PARAMETER(std::string, space, "", "", {}, "in front of each topic and frame, as robot1; empty: nothing")
  PARAMETER(int, domain, 0, "", Range(0, 232), "of DDS: the listener's ROS_DOMAIN_ID")
  PARAMETER(std::vector<std::string>, addresses, {"127.0.0.1"}, "", {},
            "of this machine, IPv4, for sending; ROS 2 has no token: everybody on such a network can read")
  PARAMETER(std::vector<std::string>, peers, {}, "", {}, "machines, IPv4, that multicast does not reach")
END_MODULE

/// Sends the agent's data as messages of ROS 2: joint_states, imu, odom, ball, robot_description and tf with
/// map -> odom -> base_footprint -> torso -> l_sole, r_sole. A line `RosBridge` in modules.cfg switches it
/// on; every DDS reader can receive it (ros2 topic echo, RViz, PlotJuggler, Foxglove). It only sends.
class RosBridge : public RosBridgeBase {
public:
  void init() override;
  void execute() override;

private:
  dds::ros::Header header(const std::string& frame) const;
  std::string frame(const std::string& name) const;
  void sendJoints();
  void sendInertial();
  void sendOdometry();
  void sendFrames();
  void sendBall();

  std::unique_ptr<dds::RosSender> sender_;
  std::string described_;  ///< the robot whose description was sent
};

}  // namespace plumbline
