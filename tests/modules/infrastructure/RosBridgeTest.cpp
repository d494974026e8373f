// What RosBridge refuses; what it sends is read by another DDS in tests/ros/RosBridgeTest.cpp, which needs
// packages.
#include "modules/infrastructure/RosBridge.h"

#include <gtest/gtest.h>

#include "support/ModuleHarness.h"
#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

std::string problemWith(const std::string& parameters) {
  test::ScratchFolder folder;
  folder.write("RosBridge.yaml", parameters);
  test::ModuleHarness<RosBridge> harness({folder.path()});
  std::string error = thrownBy([&] { harness.module(); });
  if (error.starts_with(folder.path())) error.erase(0, folder.path().size() + 1);
  return error;
}

TEST(RosBridgeParameters, aSpaceIsANameOfRos) {
  EXPECT_EQ(problemWith("space: robot 1\n"), "RosBridge.space is no name of ROS 2: letters, digits and _");
  EXPECT_EQ(problemWith("space: robot_1/\n"), "RosBridge.space is no name of ROS 2: letters, digits and _");
}

TEST(RosBridgeParameters, domainAndAddressesAreChecked) {
  EXPECT_EQ(problemWith("domain: 233\n"), "RosBridge.yaml:1: domain must be within [0, 232], not 233");
  const std::string error = problemWith("addresses: [here]\n");
  EXPECT_TRUE(error.starts_with("RosBridge: ")) << error;
  EXPECT_NE(error.find("here"), std::string::npos) << error;
}

}  // namespace
}  // namespace plumbline
