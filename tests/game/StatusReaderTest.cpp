#include "game/StatusReader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace plumbline::game;

namespace {

TEST(StatusReader, findsTheWords) {
  const auto said = statusOf("status 1.20 robot -0.50 0.00 3 ball 1.00 -2.00 going to kick");
  ASSERT_TRUE(said);
  EXPECT_EQ(said->time, 1.2);
  EXPECT_EQ(said->words, "going to kick");
  EXPECT_FALSE(statusOf("[SimSparkConnection] connected to port 3100"));
  EXPECT_FALSE(statusOf("status 1.20 robot here"));
}

TEST(StatusReader, followsAFileAndLeavesHalfALineForLater) {
  const std::string path = testing::TempDir() + "status_reader.txt";
  std::filesystem::remove(path);
  StatusReader reader(path);
  EXPECT_TRUE(reader.read().empty());
  std::ofstream file(path);
  file << "status 1 robot 0 0 0 ball 0 0 walking\nstatus 2 robot 0 0 0 ball 0 0 drib" << std::flush;
  ASSERT_EQ(reader.read().size(), 1u);
  EXPECT_EQ(reader.read()[0].words, "walking");
  file << "bling\n" << std::flush;
  ASSERT_EQ(reader.read().size(), 2u);
  EXPECT_EQ(reader.read()[1].words, "dribbling");
  EXPECT_EQ(reader.read()[1].time, 2);
}

}  // namespace
