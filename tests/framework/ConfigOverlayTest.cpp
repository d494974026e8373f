#include "framework/ConfigOverlay.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "framework/ConfigFile.h"
#include "framework/ConfigurationError.h"

namespace plumbline {
namespace {

namespace fs = std::filesystem;

class ConfigOverlay : public testing::Test {
protected:
  ConfigOverlay() {
    fs::create_directories(folder + "/type3");
    write("kick.yaml", "ballX: 0.1\nballY: 0.2\nswing: {time: 1, gains: [1, 2]}\n");
  }
  ~ConfigOverlay() override { fs::remove_all(folder); }
  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder + "/" + name) << text;
  }

  /// The error of reading with an overlay of that text, without the folder's name.
  std::string errorOf(const std::string& overlay, const std::string& name = "kick") const {
    write("type3/" + name + ".yaml", overlay);
    try {
      const ConfigFile file(name, {folder, folder + "/type3"});
    } catch (const ConfigurationError& error) {
      std::string what = error.what();
      for (std::size_t at; (at = what.find(folder + "/")) != std::string::npos;)
        what.erase(at, folder.size() + 1);
      return what;
    }
    return "no error";
  }

  const std::string folder = (fs::temp_directory_path() / ("overlay" + std::to_string(getpid()))).string();
};

TEST_F(ConfigOverlay, aWholeFileNeedsToSayNothing) {
  EXPECT_EQ(errorOf("ballX: 1\nballY: 2\nswing: {time: 3, gains: [3]}\n"), "no error");
}

TEST_F(ConfigOverlay, aFileThatLeavesValuesSaysSo) {
  EXPECT_EQ(errorOf("ballX: 1\nswing: {time: 3, gains: [3]}\n"),
            "type3/kick.yaml:1: overrides kick.yaml but not 1 of its values (ballY); give these too, or "
            "begin the file with overlay: {base: kick.yaml, values: 3}");
  EXPECT_EQ(errorOf("ballX: 1\n"),
            "type3/kick.yaml:1: overrides kick.yaml but not 3 of its values (ballY, ...); give these too, or "
            "begin the file with overlay: {base: kick.yaml, values: 1}");
  EXPECT_EQ(errorOf("overlay: {base: kick.yaml, values: 2}\nballX: 1\nswing: {time: 3}\n"), "no error");
  const ConfigFile file("kick", {folder, folder + "/type3"});
  EXPECT_EQ(file.root().get<double>("ballX"), 1);
  EXPECT_EQ(file.root().get<double>("ballY"), 0.2);
  EXPECT_EQ(file.root().get<double>("swing.time"), 3);
  EXPECT_EQ(file.root().get<std::vector<int>>("swing.gains").size(), 2u);
  EXPECT_NO_THROW(file.checkUnknown());
}

TEST_F(ConfigOverlay, aLostLineIsAnError) {
  EXPECT_EQ(errorOf("overlay: {base: kick.yaml, values: 2}\nballX: 1\n"),
            "type3/kick.yaml:1: overlay.values is 2, but there are 1 in the file: was a line lost or added? "
            "If not, "
            "write 1");
  EXPECT_EQ(errorOf("overlay: {base: kick.yaml, values: 1}\n"),
            "type3/kick.yaml:1: overlay.values is 1, but there are 0 in the file: was a line lost or added? "
            "If not, "
            "write 0");
}

TEST_F(ConfigOverlay, theLineItselfIsChecked) {
  EXPECT_EQ(errorOf("overlay: kick.yaml\nballX: 1\n"),
            "type3/kick.yaml:1: overlay must be {base: kick.yaml, values: 1}");
  EXPECT_EQ(errorOf("overlay: {base: kick.yaml}\nballX: 1\n"),
            "type3/kick.yaml:1: overlay needs base and values");
  EXPECT_EQ(errorOf("overlay: {base: walk.yaml, values: 1}\nballX: 1\n"),
            "type3/kick.yaml:1: overlay.base is walk.yaml, but this file overrides kick.yaml");
  EXPECT_EQ(errorOf("overlay: {base: kick.yaml, value: 1}\nballX: 1\n"),
            "type3/kick.yaml:1: unknown key \"overlay.value\"; did you mean \"values\"?");
}

TEST_F(ConfigOverlay, everyLineOfTheProjectsOverlaysIsMissed) {
  for (const char* type : {"type1", "type4"}) {
    std::size_t lines = 0, values = 0;
    std::ifstream stream(std::string("config/walks/") + type + "/over/walking.yaml");
    std::vector<std::string> text;
    for (std::string line; std::getline(stream, line);) text.push_back(line);
    fs::copy_file("config/walking.yaml", folder + "/walking.yaml", fs::copy_options::overwrite_existing);
    for (std::size_t gone = 0; gone < text.size(); ++gone) {
      if (text[gone].starts_with("overlay:"))
        values = std::stoul(text[gone].substr(text[gone].find("values: ") + 8));
      if (text[gone].starts_with("#") || text[gone].starts_with("overlay:") || text[gone].ends_with(":"))
        continue;
      std::string rest;
      for (std::size_t i = 0; i < text.size(); ++i)
        if (i != gone) rest += text[i] + "\n";
      EXPECT_NE(errorOf(rest, "walking"), "no error") << type << " without " << text[gone];
      ++lines;
    }
    EXPECT_GT(lines, 10u) << type;
    EXPECT_EQ(lines, values) << type << ": what the overlay says of itself";
  }
}

}  // namespace
}  // namespace plumbline
