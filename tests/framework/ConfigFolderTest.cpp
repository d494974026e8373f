#include "framework/ConfigFolder.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "framework/ConfigurationError.h"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

/// A test in a folder of its own; the current one comes back at the end.
class ConfigFolder : public testing::Test {
protected:
  ConfigFolder()
      : before(fs::current_path()),
        folder(fs::temp_directory_path() / ("config" + std::to_string(getpid()))) {
    fs::create_directories(folder);
    fs::current_path(folder);
  }
  ~ConfigFolder() override {
    fs::current_path(before);
    fs::remove_all(folder);
  }
  const fs::path before, folder;
};

TEST_F(ConfigFolder, ofTheCurrentFolderComesFirst) {
  fs::create_directories("config");
  EXPECT_NE(configFolder(), "config");  // a folder of that name alone is somebody else's
  fs::create_directories("config/platforms");
  EXPECT_EQ(configFolder(), "config");
  EXPECT_EQ(configPath("robots/x.json"), "config/robots/x.json");
}

TEST_F(ConfigFolder, elseThatOfTheProgramIsFoundFromAnyFolder) {
  EXPECT_TRUE(fs::equivalent(configFolder(), before / "config")) << configFolder();
  EXPECT_TRUE(fs::exists(configPath("robots/nao_v5.json")));
}

TEST_F(ConfigFolder, theProgramsFolderIsWhereItsFileLies) {
  EXPECT_TRUE(fs::path(programFolder()).is_absolute());
  EXPECT_TRUE(fs::is_directory(programFolder()));
}

TEST_F(ConfigFolder, aFolderThatIsNotThereIsRefused) {
  try {
    useConfigFolder("nowhere");
    FAIL();
  } catch (const ConfigurationError& error) {
    EXPECT_STREQ(error.what(), "--config nowhere: there is no such folder");
  }
}

TEST_F(ConfigFolder, theGivenOneIsUsed) {
  fs::create_directories("mine");
  EXPECT_EXIT(
      {
        useConfigFolder("mine");
        _exit(configPath("a") == "mine/a" ? 0 : 1);
      },
      testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace plumbline
