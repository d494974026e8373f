// What the agent sends to ROS 2, read by a DDS of other people: Cyclone DDS, with readers generated from ROS
// 2's definitions.
#include "modules/infrastructure/RosBridge.h"

#include <RosTypes.h>
#include <dds/dds.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <thread>

#include "robot/HumanoidModel.h"
#include "robot/MechanismFile.h"
#include "robot/UrdfWriter.h"
#include "support/ModuleHarness.h"

namespace plumbline {
namespace {

int rosDomain() { return 100 + static_cast<int>(getpid()) % 100; }

/// One participant of Cyclone DDS on the loopback.
class Listener {
public:
  Listener() {
    setenv("CYCLONEDDS_URI",
           "<General><Interfaces><NetworkInterface address=\"127.0.0.1\" "
           "multicast=\"true\"/></Interfaces></General>",
           1);
    participant = dds_create_participant(static_cast<dds_domainid_t>(rosDomain()), nullptr, nullptr);
  }
  ~Listener() { dds_delete(participant); }

  /// Waits for a message of the topic and shows it to `look`; meanwhile `send` is called again and again.
  template <typename Message>
  bool read(const dds_topic_descriptor_t& type, const char* topicName, bool lasting,
            const std::function<void()>& send, const std::function<void(const Message&)>& look) {
    const dds_entity_t topic = dds_create_topic(participant, &type, topicName, nullptr, nullptr);
    dds_qos_t* qos = dds_create_qos();
    dds_qset_reliability(qos, DDS_RELIABILITY_RELIABLE, DDS_SECS(1));
    dds_qset_durability(qos, lasting ? DDS_DURABILITY_TRANSIENT_LOCAL : DDS_DURABILITY_VOLATILE);
    const dds_entity_t reader = dds_create_reader(participant, topic, qos, nullptr);
    dds_delete_qos(qos);
    bool found = false;
    for (int i = 0; i < 1500 && !found; ++i) {
      send();
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
      void* sample = nullptr;
      dds_sample_info_t info{};
      if (dds_take(reader, &sample, &info, 1, 1) > 0 && info.valid_data) {
        look(*static_cast<const Message*>(sample));
        found = true;
      }
      if (sample) dds_return_loan(reader, &sample, 1);
    }
    dds_delete(reader);
    return found;
  }

  dds_entity_t participant;
};

/// A robot with known values in every representation.
class RosBridgeTest : public testing::Test {
protected:
  RosBridgeTest() {
    auto& frame = harness.input<FrameInfo>();
    frame.time = 12.25, frame.cycle = 3, frame.cycleSeconds = 0.02;
    auto& robot = harness.input<RobotDescription>();
    robot.name = "nao_v5";
    robot.model = Humanoid(findMechanism("nao_v5")).model();
    harness.input<JointData>().angles[lKneePitch] = 0.5;
    auto& sensors = harness.input<SensorData>();
    sensors.gyro = Vec3(0.1, 0.2, 0.3), sensors.acc = Vec3(1, 2, 9.5);
    auto& odometry = harness.input<Odometry>();
    odometry.total = Pose2(Vec2(1, 2), 0.5), odometry.step = Pose2(Vec2(0.01, 0), 0.002);
    harness.input<TorsoPose>().T_ground_torso = translation(0, 0, 0.33);
    harness.input<FKModel>().T_torso_leftSole = translation(0, 0.05, -0.33);
    auto& pose = harness.input<RobotPose>();
    pose.pose = Pose2(Vec2(-3, 1), 0.5), pose.valid = true;
    auto& ball = harness.input<BallPos>();
    ball.relative = Vec2(0.5, -0.25), ball.valid = true;
    harness.module();
  }

  template <typename Message>
  void expectRead(const dds_topic_descriptor_t& type, const char* topic,
                  const std::function<void(const Message&)>& look, bool lasting = false) {
    EXPECT_TRUE(listener.read<Message>(
        type, topic, lasting, [&] { harness.cycle(); }, look))
        << topic;
  }

  Listener listener;
  test::ModuleHarness<RosBridge> harness{{configWithDomain()}};

private:
  static std::string configWithDomain() {
    const std::string folder = testing::TempDir() + "ros" + std::to_string(getpid());
    std::filesystem::create_directories(folder);
    std::ofstream(folder + "/RosBridge.yaml") << "space: robot1\ndomain: " << rosDomain() << '\n';
    return folder;
  }
};

TEST_F(RosBridgeTest, sendsWhatAnIndependentProgramReads) {
  expectRead<sensor_msgs_msg_dds__JointState_>(sensor_msgs_msg_dds__JointState__desc,
                                               "rt/robot1/joint_states", [](const auto& m) {
                                                 EXPECT_EQ(m.header_.stamp_.sec_, 12);
                                                 EXPECT_EQ(m.header_.stamp_.nanosec_, 250'000'000u);
                                                 EXPECT_STREQ(m.header_.frame_id_, "robot1/torso");
                                                 ASSERT_EQ(m.name_._length, m.position_._length);
                                                 EXPECT_EQ(m.name_._length, 24u) << "wrists and no toes";
                                                 EXPECT_EQ(m.velocity_._length, 0u);
                                                 int knees = 0;
                                                 for (unsigned i = 0; i < m.name_._length; ++i) {
                                                   if (std::string(m.name_._buffer[i]) != "LKneePitch")
                                                     continue;
                                                   EXPECT_EQ(m.position_._buffer[i], 0.5);
                                                   ++knees;
                                                 }
                                                 EXPECT_EQ(knees, 1);
                                               });
  expectRead<sensor_msgs_msg_dds__Imu_>(sensor_msgs_msg_dds__Imu__desc, "rt/robot1/imu", [](const auto& m) {
    EXPECT_EQ(m.orientation_covariance_[0], -1);
    EXPECT_EQ(m.angular_velocity_.y_, 0.2);
    EXPECT_EQ(m.linear_acceleration_.z_, 9.5);
  });
  expectRead<nav_msgs_msg_dds__Odometry_>(nav_msgs_msg_dds__Odometry__desc, "rt/robot1/odom",
                                          [](const auto& m) {
                                            EXPECT_STREQ(m.header_.frame_id_, "robot1/odom");
                                            EXPECT_STREQ(m.child_frame_id_, "robot1/base_footprint");
                                            EXPECT_EQ(m.pose_.pose_.position_.y_, 2);
                                            EXPECT_NEAR(m.pose_.pose_.orientation_.z_, std::sin(0.25), 1e-12);
                                            EXPECT_NEAR(m.twist_.twist_.linear_.x_, 0.5, 1e-12);
                                            EXPECT_NEAR(m.twist_.twist_.angular_.z_, 0.1, 1e-12);
                                          });
  expectRead<tf2_msgs_msg_dds__TFMessage_>(tf2_msgs_msg_dds__TFMessage__desc, "rt/tf", [](const auto& m) {
    ASSERT_EQ(m.transforms_._length, 5u);
    const char* const chain[][2] = {{"robot1/map", "robot1/odom"},
                                    {"robot1/odom", "robot1/base_footprint"},
                                    {"robot1/base_footprint", "robot1/torso"},
                                    {"robot1/torso", "robot1/l_sole"},
                                    {"robot1/torso", "robot1/r_sole"}};
    for (unsigned i = 0; i < 5; ++i) {
      EXPECT_STREQ(m.transforms_._buffer[i].header_.frame_id_, chain[i][0]);
      EXPECT_STREQ(m.transforms_._buffer[i].child_frame_id_, chain[i][1]);
    }
    // Both have turned by 0.5, so the map is moved alone.
    EXPECT_NEAR(m.transforms_._buffer[0].transform_.translation_.x_, -4, 1e-12);
    EXPECT_NEAR(m.transforms_._buffer[0].transform_.translation_.y_, -1, 1e-12);
    EXPECT_EQ(m.transforms_._buffer[2].transform_.translation_.z_, 0.33);
    EXPECT_EQ(m.transforms_._buffer[3].transform_.translation_.y_, 0.05);
  });
  expectRead<geometry_msgs_msg_dds__PointStamped_>(geometry_msgs_msg_dds__PointStamped__desc,
                                                   "rt/robot1/ball", [](const auto& m) {
                                                     EXPECT_EQ(m.point_.x_, 0.5);
                                                     EXPECT_EQ(m.point_.y_, -0.25);
                                                   });
  // Sent once, long before this reader came.
  expectRead<std_msgs_msg_dds__String_>(
      std_msgs_msg_dds__String__desc, "rt/robot1/robot_description",
      [](const auto& m) { EXPECT_EQ(m.data_, urdfOf(Humanoid(findMechanism("nao_v5")).model())); }, true);
}

}  // namespace
}  // namespace plumbline
