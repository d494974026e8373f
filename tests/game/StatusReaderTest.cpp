#include "game/StatusReader.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

using namespace plumbline::game;

namespace {

TEST(StatusReader, findsTheWords) {
  EXPECT_EQ(wordsOfStatus("status 1.20 robot -0.50 0.00 3 ball 1.00 -2.00 going to kick"), "going to kick");
  EXPECT_EQ(wordsOfStatus("[SimSparkConnection] connected to port 3100"), "");
  EXPECT_EQ(wordsOfStatus("status 1.20 robot here"), "");
}

TEST(StatusReader, followsAFileAndLeavesHalfALineForLater) {
  const std::string path = testing::TempDir() + "status_reader.txt";
  std::filesystem::remove(path);
  StatusReader reader(path);
  EXPECT_EQ(reader.read(), "");
  std::ofstream file(path);
  file << "status 1 robot 0 0 0 ball 0 0 walking\nstatus 2 robot 0 0 0 ball 0 0 drib" << std::flush;
  EXPECT_EQ(reader.read(), "walking");
  file << "bling\n" << std::flush;
  EXPECT_EQ(reader.read(), "dribbling");
  EXPECT_EQ(reader.read(), "dribbling");
}

}  // namespace
