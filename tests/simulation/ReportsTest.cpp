#include "simulation/server/Reports.h"

#include <gtest/gtest.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace {
int syncs = 0;
}

/// In the place of the C library's: counts, and does the same.
extern "C" int fsync(int fd) {
  ++syncs;
  return static_cast<int>(syscall(SYS_fsync, fd));
}

namespace plumbline::simulation {
namespace {

TEST(Reports, portsThatThereAreNotAreLeftOut) {
  const test::ScratchFolder scratch;
  writePorts(scratch / "ports", 3100, 3200);
  EXPECT_EQ(scratch.read("ports"), "{\"agent\": 3100, \"monitor\": 3200}\n");
  writePorts(scratch / "ports", 3100, 3200, 8080);
  EXPECT_EQ(scratch.read("ports"), "{\"agent\": 3100, \"monitor\": 3200, \"web\": 8080}\n");
  writePorts(scratch / "ports", 3100, 3200, 0, 3201);
  EXPECT_EQ(scratch.read("ports"), "{\"agent\": 3100, \"monitor\": 3200, \"field\": 3201}\n");
}

TEST(Reports, statisticsOfARunAndOfNone) {
  const test::ScratchFolder scratch;
  ServerStatistics statistics;
  writeStatistics(scratch / "none", statistics);
  EXPECT_EQ(scratch.read("none"),
            "{\"cycles\": 0, \"cpu_us_per_cycle\": 0.00, \"sim_s\": 0.00, \"wall_s\": 0.000, "
            "\"x_real_time\": 0.00}\n");
  statistics.cycles = 100;
  statistics.cpuSeconds = 0.05;
  statistics.simulatedSeconds = 2;
  statistics.wallSeconds = 0.5;
  writeStatistics(scratch / "some", statistics);
  EXPECT_EQ(scratch.read("some"),
            "{\"cycles\": 100, \"cpu_us_per_cycle\": 500.00, \"sim_s\": 2.00, \"wall_s\": 0.500, "
            "\"x_real_time\": 4.00}\n");
}

TEST(Reports, outlastALossOfPower) {
  const test::ScratchFolder scratch;
  const auto syncsOf = [](const auto& write) {
    syncs = 0;
    write();
    return syncs;
  };
  EXPECT_EQ(syncsOf([&] { writePorts(scratch / "ports", 3100, 3200); }), 2) << "the file and its folder";
  EXPECT_EQ(syncsOf([&] { writeStatistics(scratch / "statistics", {}); }), 2);
}

TEST(Reports, aFolderThatThereIsNotIsNamed) {
  EXPECT_EQ(thrownBy([] { writePorts("/no/such/folder/ports", 1, 2); }),
            "cannot write /no/such/folder/ports: No such file or directory");
}

}  // namespace
}  // namespace plumbline::simulation
