#include "framework/ConfigFile.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <Eigen/Core>
#include <filesystem>
#include <fstream>
#include <functional>

#include "framework/ConfigurationError.h"
#include "framework/TestModules.h"

namespace plumbline {

/// What it reads is set by each test.
std::function<void(const Config&)>& configReader() {
  static std::function<void(const Config&)> function;
  return function;
}

MODULE(ConfigReader)
END_MODULE
class ConfigReader : public ConfigReaderBase {
public:
  void init() override { configReader()(config); }
};
MAKE_MODULE(ConfigReader)

namespace {

/// Config files in a folder of their own. Error texts have the folder's name cut off.
class ConfigFileTest : public testing::Test {
protected:
  ConfigFileTest() { std::filesystem::create_directories(folder + "type3"); }
  ~ConfigFileTest() override { std::filesystem::remove_all(folder); }

  void write(const std::string& name, const std::string& text) { std::ofstream(folder + name) << text; }

  std::string errorOf(const std::function<void()>& function) const {
    try {
      function();
    } catch (const ConfigurationError& error) {
      std::string text = error.what();
      for (std::size_t at = text.find(folder); at != std::string::npos; at = text.find(folder)) {
        text.erase(at, folder.size());
      }
      return text;
    }
    return "no error";
  }

  /// The error of reading something from a file of this text.
  std::string errorOf(const std::string& text, const std::function<void(const ConfigSection&)>& read) {
    write("A.yaml", text);
    return errorOf([&] {
      const ConfigFile file(folder + "A.yaml");
      read(file.root());
      file.checkUnknown();
    });
  }

  /// The error of starting an agent whose ConfigReader reads this.
  std::string errorOfAgent(const std::function<void(const Config&)>& read) {
    configReader() = read;
    return errorOf([&] {
      Controller controller({"modules.cfg", {folder, folder + "type3"}}, "ConfigReader\n");
      controller.init();
    });
  }

  const std::string folder = testing::TempDir() + "config" + std::to_string(getpid()) + "/";
};

TEST_F(ConfigFileTest, readsEveryType) {
  write("A.yaml",
        "flag: true\ninteger: -3\ncount: 4\nlarge: 9000000000\nreal: 2.5\nwhole: 2\nsmall: 1e-3\n"
        "text: two words\nquoted: \"5\"\nlist: [1, 2.5]\nwords:\n  - a\n  - b\nthree: [1, 2, 3]\n"
        "matrix: [[1, 2], [3, 4]]\nnested: {inner: {deep: 7}}\n");
  const ConfigFile file(folder + "A.yaml");
  const ConfigSection& root = file.root();
  EXPECT_EQ(root.get<bool>("flag"), true);
  EXPECT_EQ(root.get<int>("integer"), -3);
  EXPECT_EQ(root.get<unsigned>("count"), 4u);
  EXPECT_EQ(root.get<std::int64_t>("large"), 9000000000);
  EXPECT_EQ(root.get<double>("real"), 2.5);
  EXPECT_EQ(root.get<double>("whole"), 2);
  EXPECT_EQ(root.get<float>("small"), 1e-3f);
  EXPECT_EQ(root.get<std::string>("text"), "two words");
  EXPECT_EQ(root.get<std::string>("quoted"), "5");
  EXPECT_EQ(root.get<std::vector<double>>("list"), (std::vector<double>{1, 2.5}));
  EXPECT_EQ(root.get<std::vector<std::string>>("words"), (std::vector<std::string>{"a", "b"}));
  EXPECT_EQ((root.get<std::array<int, 3>>("three")), (std::array<int, 3>{1, 2, 3}));
  EXPECT_EQ(root.get<Eigen::Vector3d>("three"), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(root.get<Eigen::Matrix2d>("matrix"), (Eigen::Matrix2d() << 1, 2, 3, 4).finished());
  EXPECT_EQ((root.get<std::vector<std::vector<int>>>("matrix")),
            (std::vector<std::vector<int>>{{1, 2}, {3, 4}}));
  EXPECT_EQ(root.get<int>("nested.inner.deep"), 7);
  EXPECT_EQ(root.section("nested").get<int>("inner.deep"), 7);
  EXPECT_NO_THROW(file.checkUnknown());
}

TEST_F(ConfigFileTest, namesAMissingKey) {
  const auto noise = [](const ConfigSection& root) { root.get<double>("noise"); };
  EXPECT_EQ(errorOf("", noise), "A.yaml:1: missing key \"noise\"");
  EXPECT_EQ(errorOf("# a\nother: 3\n", noise), "A.yaml:1: missing key \"noise\"");
  EXPECT_EQ(errorOf("# a\nnoize: 3\n", noise), "A.yaml:1: missing key \"noise\"; is it \"noize\" in line 2?");
  const auto height = [](const ConfigSection& root) { root.get<double>("walk.stepHeight"); };
  EXPECT_EQ(errorOf("a: 1\nwalk:\n  stepHigh: 3\n", height),
            "A.yaml:2: missing key \"walk.stepHeight\"; is it \"stepHigh\" in line 3?");
  EXPECT_EQ(errorOf("wakl:\n  stepHeight: 3\n", height),
            "A.yaml:1: missing key \"walk.stepHeight\"; is it \"wakl\" in line 1?");
  EXPECT_EQ(errorOf("walk: 3\n", height), "A.yaml:1: walk must be a map, not \"3\"");
  EXPECT_EQ(
      errorOf("a: 1\nwalk:\n  b: 1\n", [](const ConfigSection& root) { root.section("walk").get<int>("c"); }),
      "A.yaml:2: missing key \"walk.c\"");
}

TEST_F(ConfigFileTest, namesAnUnknownKey) {
  const auto read = [](const ConfigSection& root) {
    root.find<double>("noise");
    root.find<double>("walk.stepHeight");
    root.find<double>("walk.stepLength");
  };
  EXPECT_EQ(errorOf("a: 1\n", read), "A.yaml:1: unknown key \"a\"");
  EXPECT_EQ(errorOf("\n\nnoize: 1\n", read), "A.yaml:3: unknown key \"noize\"; did you mean \"noise\"?");
  EXPECT_EQ(errorOf("noise: 1\nwalk:\n  stepHeight: 1\n  stepHight: 2\n", read),
            "A.yaml:4: unknown key \"walk.stepHight\"; did you mean \"stepHeight\"?");
  EXPECT_EQ(errorOf("wlak:\n  stepHeight: 1\n", read),
            "A.yaml:1: unknown key \"wlak\"; did you mean \"walk\"?");
  EXPECT_EQ(errorOf("noise: 1\nwalk: {stepHeight: 3}\n", read), "no error");
}

TEST_F(ConfigFileTest, namesAWrongType) {
  const auto as = [&]<typename T>(T, const std::string& value) {
    return errorOf("# type\nkey: " + value + "\n", [](const ConfigSection& root) { root.get<T>("key"); });
  };
  EXPECT_EQ(as(0.0, "abc"), "A.yaml:2: key must be a number, not \"abc\"");
  EXPECT_EQ(as(0.0, "\"1\""), "A.yaml:2: key must be a number, not \"1\"");
  EXPECT_EQ(as(0.0, "1 m"), "A.yaml:2: key must be a number, not \"1 m\"");
  EXPECT_EQ(as(0.0, ".nan"), "A.yaml:2: key must be a number, not \".nan\"");
  EXPECT_EQ(as(0.0, "inf"), "A.yaml:2: key must be a number, not \"inf\"");
  EXPECT_EQ(as(0.0, "1e999"), "A.yaml:2: key must be a number, not \"1e999\"");
  EXPECT_EQ(as(0.0, ""), "A.yaml:2: key must be a number, not empty");
  EXPECT_EQ(as(0.0, "[1]"), "A.yaml:2: key must be a number, not a list of 1");
  EXPECT_EQ(as(0.0, "{a: 1}"), "A.yaml:2: key must be a number, not a map");
  EXPECT_EQ(as(0, "1.5"), "A.yaml:2: key must be an integer, not \"1.5\"");
  EXPECT_EQ(as(0, "3000000000"), "A.yaml:2: key must be an integer, not \"3000000000\"");
  EXPECT_EQ(as(0u, "-1"), "A.yaml:2: key must be an integer not below 0, not \"-1\"");
  EXPECT_EQ(as(true, "yes"), "A.yaml:2: key must be true or false, not \"yes\"");
  EXPECT_EQ(as(true, "1"), "A.yaml:2: key must be true or false, not \"1\"");
  EXPECT_EQ(as(std::string(), "[a]"), "A.yaml:2: key must be a text, not a list of 1");
  EXPECT_EQ(as(std::vector<double>(), "1"), "A.yaml:2: key must be a list, not \"1\"");
  EXPECT_EQ(as(std::vector<double>(), "\n  - 1\n  - x"), "A.yaml:4: key[1] must be a number, not \"x\"");
  EXPECT_EQ(as(std::array<double, 3>(), "[1, 2]"), "A.yaml:2: key must be a list of 3, not a list of 2");
  EXPECT_EQ(as(Eigen::Matrix2d(), "[[1, 2], [3]]"), "A.yaml:2: key[1] must be a list of 2, not a list of 1");
}

TEST_F(ConfigFileTest, namesAValueOutOfRange) {
  const auto in = [&](const Range& range, const std::string& value) {
    return errorOf("noise: " + value + "\n",
                   [&](const ConfigSection& root) { root.get<double>("noise", range); });
  };
  EXPECT_EQ(in({0, 1}, "1.5"), "A.yaml:1: noise must be within [0, 1], not 1.5");
  EXPECT_EQ(in({0, 0.25}, "-1"), "A.yaml:1: noise must be within [0, 0.25], not -1");
  EXPECT_EQ(in(Range::atLeast(0), "-1e-3"), "A.yaml:1: noise must be at least 0, not -1e-3");
  EXPECT_EQ(in(Range::atMost(10), "11"), "A.yaml:1: noise must be at most 10, not 11");
  EXPECT_EQ(in({0, 1}, "1"), "no error");
  EXPECT_EQ(errorOf("gains: [1, 2, 3]\n",
                    [](const ConfigSection& root) { root.get<std::vector<double>>("gains", 0, 2); }),
            "A.yaml:1: gains[2] must be within [0, 2], not 3");
}

TEST_F(ConfigFileTest, readsWordsSectionsAndLists) {
  const std::string text =
      "foot: left\nskills:\n  - name: kick\n    power: 2\n  - name: walk\n    power: 1\n"
      "joints: {knee: 1, hip: 2}\n";
  const auto read = [](const ConfigSection& root) {
    EXPECT_EQ(root.choice("foot", {"right", "left"}), 1u);
    const auto skills = root.list("skills");
    ASSERT_EQ(skills.size(), 2u);
    EXPECT_EQ(skills[0].get<std::string>("name"), "kick");
    EXPECT_EQ(skills[1].get<std::string>("name"), "walk");
    EXPECT_EQ(skills[0].get<int>("power"), 2);
    EXPECT_EQ(skills[1].get<int>("power"), 1);
    const ConfigSection joints = root.section("joints");
    EXPECT_EQ(joints.keys(), (std::vector<std::string>{"knee", "hip"}));
    for (const std::string& joint : joints.keys()) joints.get<int>(joint);
    EXPECT_FALSE(root.has("other"));
    EXPECT_EQ(root.find<int>("other"), std::nullopt);
  };
  EXPECT_EQ(errorOf(text, read), "no error");
}

TEST_F(ConfigFileTest, unknownKeysWithinListsAreNamed) {
  EXPECT_EQ(errorOf("skills:\n  - name: kick\n    powr: 2\n",
                    [](const ConfigSection& root) {
                      root.list("skills")[0].get<std::string>("name");
                      root.list("skills")[0].find<int>("power");
                    }),
            "A.yaml:3: unknown key \"skills[0].powr\"; did you mean \"power\"?");
  EXPECT_EQ(errorOf("foot: up\n",
                    [](const ConfigSection& root) {
                      root.choice("foot", {"left", "right", "both"});
                    }),
            "A.yaml:1: foot must be left, right or both, not \"up\"");
  EXPECT_EQ(errorOf("low: 3\nhigh: 2\n",
                    [](const ConfigSection& root) {
                      if (root.get<int>("high") < root.get<int>("low"))
                        root.fail("high", "must not be below low");
                    }),
            "A.yaml:2: high must not be below low");
}

TEST_F(ConfigFileTest, namesBrokenFiles) {
  const auto nothing = [](const ConfigSection&) {};
  EXPECT_EQ(errorOf("a: [1, 2\nb: 3\n", nothing), "A.yaml:2: broken YAML: end of sequence flow not found");
  EXPECT_EQ(errorOf("a: 1\na: 2\n", nothing), "A.yaml:2: key \"a\" is already in line 1");
  EXPECT_EQ(errorOf("a.b: 1\n", nothing), "A.yaml:1: key \"a.b\" contains a dot; nest the keys instead");
  EXPECT_EQ(errorOf("- a\n- b\n", nothing), "A.yaml:1: expected lines of the form \"key: value\"");
  EXPECT_EQ(errorOf("just text\n", nothing), "A.yaml:1: expected lines of the form \"key: value\"");
  EXPECT_EQ(errorOf(std::string((4 << 20) + 1, '#'), nothing), "A.yaml: is larger than 4 MB");
  // A small file that unfolds to 10^9 values.
  std::string bomb = "a0: &a0 [1,1,1,1,1,1,1,1,1,1]\n";
  for (int i = 1; i < 9; ++i) {
    const std::string before = "*a" + std::to_string(i - 1);
    bomb += "a" + std::to_string(i) + ": &a" + std::to_string(i) + " [" + before;
    for (int j = 1; j < 10; ++j) bomb += "," + before;
    bomb += "]\n";
  }
  EXPECT_EQ(errorOf(bomb, nothing), "A.yaml:5: more than 100000 values");
  EXPECT_EQ(errorOf(std::string("a: ") + std::string(40, '[') + std::string(40, ']') + "\n", nothing),
            "A.yaml:1: nested deeper than 32 levels");
  EXPECT_EQ(errorOf([&] { ConfigFile file(folder + "nowhere.yaml"); }),
            "nowhere.yaml: cannot be read: No such file or directory");
}

TEST_F(ConfigFileTest, laterDirectoriesOverrideSingleKeys) {
  write("Walk.yaml", "speed: 1\nstep: {height: 2, length: 3}\ngains: [1, 2]\n");
  write("type3/Walk.yaml",
        "overlay: {base: Walk.yaml, values: 3}\nstep: {height: 20}\ngains: [5]\nmass: 4\n");
  const ConfigFile file("Walk", {folder, folder + "type3"});
  const ConfigSection& root = file.root();
  EXPECT_EQ(root.get<int>("speed"), 1);
  EXPECT_EQ(root.get<int>("step.height"), 20);
  EXPECT_EQ(root.get<int>("step.length"), 3);
  EXPECT_EQ(root.get<std::vector<int>>("gains"), (std::vector<int>{5}));
  EXPECT_EQ(errorOf([&] { file.checkUnknown(); }), "type3/Walk.yaml:4: unknown key \"mass\"");
  EXPECT_EQ(root.get<int>("mass"), 4);
  EXPECT_NO_THROW(file.checkUnknown());
}

TEST_F(ConfigFileTest, errorsNameTheFileOfTheValue) {
  write("Walk.yaml", "a: 1\nb: x\n");
  write("type3/Walk.yaml", "overlay: {base: Walk.yaml, values: 1}\na: y\n");
  const ConfigFile file("Walk", {folder, folder + "type3"});
  EXPECT_EQ(errorOf([&] { file.root().get<int>("a"); }),
            "type3/Walk.yaml:2: a must be an integer, not \"y\"");
  EXPECT_EQ(errorOf([&] { file.root().get<int>("b"); }), "Walk.yaml:2: b must be an integer, not \"x\"");
  EXPECT_EQ(errorOf([&] {
              ConfigFile missing("Run", {"one", "two"});
            }),
            "no config file Run.yaml in one, two");
}

TEST_F(ConfigFileTest, modulesReadTheFileOfTheirNameAndOthers) {
  write("ConfigReader.yaml", "noise: 0.5\n");
  write("Shared.yaml", "a: 1\nb: 2\n");
  double noise = 0;
  const auto read = [&](const Config& config) {
    noise = config.get<double>("noise", {0, 1});
    EXPECT_TRUE(config.exists("Shared"));
    EXPECT_FALSE(config.exists("Other"));
    config.file("Shared").get<int>("a");
  };
  EXPECT_EQ(errorOfAgent(read), "Shared.yaml:2: unknown key \"b\"");
  EXPECT_EQ(noise, 0.5);
  write("type3/ConfigReader.yaml", "noise: 0.25\nnoice: 1\n");
  write("Shared.yaml", "a: 1\n");
  EXPECT_EQ(errorOfAgent(read), "type3/ConfigReader.yaml:2: unknown key \"noice\"; did you mean \"noise\"?");
  write("type3/ConfigReader.yaml", "noise: 0.25\n");
  EXPECT_EQ(errorOfAgent(read), "no error");
  EXPECT_EQ(noise, 0.25);
}

TEST_F(ConfigFileTest, aModuleThatReadsNothingHasNoKeys) {
  const auto nothing = [](const Config&) {};
  EXPECT_EQ(errorOfAgent(nothing), "no error");
  write("ConfigReader.yaml", "left: over\n");
  EXPECT_EQ(errorOfAgent(nothing), "ConfigReader.yaml:1: unknown key \"left\"");
  std::filesystem::remove(folder + "ConfigReader.yaml");
  EXPECT_EQ(errorOfAgent([](const Config& config) { config.get<int>("a"); }),
            "no config file ConfigReader.yaml in , type3");
}

}  // namespace
}  // namespace plumbline
