#include "tunnel/RankCommand.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

#include "support/FarOff.h"
#include "support/Thrown.h"

namespace plumbline::tunnel {
namespace {

int statusOf(RankCommand& command) {
  command.start();
  comesTrue([&] { return command.status().has_value(); });
  return command.status().value_or(-1);
}

TEST(RankCommand, hasPortAndRankInItsArgumentsAndItsEnvironment) {
  const std::string file = testing::TempDir() + "rank_command.txt";
  std::filesystem::remove(file);
  setenv("OMPI_COMM_WORLD_RANK", "7", 1);
  RankCommand command({"sh", "-c",
                       "echo p{port}x{port} r{rank} $MPITUNNEL_PORT $MPITUNNEL_RANK "
                       "${OMPI_COMM_WORLD_RANK-none} {} {host} > " +
                           file},
                      3400, 2);
  EXPECT_EQ(command.name(), "sh");
  EXPECT_FALSE(command.status().has_value());
  EXPECT_EQ(statusOf(command), 0);
  unsetenv("OMPI_COMM_WORLD_RANK");
  std::string line;
  std::getline(std::ifstream(file), line);
  EXPECT_EQ(line, "p3400x3400 r2 3400 2 none {} {host}");
}

TEST(RankCommand, tellsItsStatusAndEndsWhenItIsStopped) {
  RankCommand ends({"sh", "-c", "exit 5"}, 1, 1);
  EXPECT_EQ(statusOf(ends), 5);
  RankCommand waits({"sleep", "100"}, 1, 1);
  waits.stop(0);  // not started yet
  waits.start();
  EXPECT_FALSE(waits.status().has_value());
  waits.stop(1);
  EXPECT_EQ(waits.status(), 128 + 15);
}

TEST(RankCommand, thatIsNotThereIsAnError) {
  RankCommand command({"no-such-command"}, 1, 1);
  EXPECT_EQ(thrownBy([&] { command.start(); }), "cannot start no-such-command: No such file or directory");
}

}  // namespace
}  // namespace plumbline::tunnel
