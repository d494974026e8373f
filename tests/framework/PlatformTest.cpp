#include "framework/Platform.h"

#include <gtest/gtest.h>

#include "framework/ConfigurationError.h"

namespace plumbline {
namespace {

class TestPlatform : public Platform {
public:
  void declareOptions(CommandLine&) override {}
  std::vector<std::string> configFolders(const std::string& config) const override {
    return {config + "/robots/test"};
  }
  void addObjects(ModuleObjects&, std::function<void(const std::string&)>) const override {}
};
MAKE_PLATFORM("testbench", TestPlatform)

std::string errorOf(const std::string& name) {
  try {
    Platforms::make(name);
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return "no error";
}

std::string chosen(std::vector<const char*> words) {
  return chosenPlatform(static_cast<int>(words.size()), words.data(), "usual");
}

TEST(Platforms, areMadeByName) {
  EXPECT_EQ(Platforms::names(), std::vector<std::string>{"testbench"});
  EXPECT_EQ(Platforms::make("testbench")->configFolders("config"),
            std::vector<std::string>{"config/robots/test"});
}

TEST(Platforms, anUnknownNameIsRefused) {
  EXPECT_EQ(errorOf("testbensh"), "--platform testbensh: unknown platform; did you mean \"testbench\"?");
  EXPECT_EQ(errorOf("nao"), "--platform nao: unknown platform; there are: testbench");
}

TEST(Platforms, theCommandLineChoosesOneBeforeItsOptionsAreKnown) {
  EXPECT_EQ(chosen({"agent"}), "usual");
  EXPECT_EQ(chosen({"agent", "--team", "A", "--platform", "nao", "--once"}), "nao");
  EXPECT_EQ(chosen({"agent", "--platform=nao"}), "nao");
  EXPECT_EQ(chosen({"agent", "--platform="}), "");
  EXPECT_EQ(chosen({"agent", "--platform"}), "usual") << "what is missing is said when the line is read";
  EXPECT_EQ(chosen({"agent", "--platforms", "nao"}), "usual");
  EXPECT_EQ(chosen({"agent", "--", "--platform", "nao"}), "usual");
}

TEST(Platforms, aSecondOneOfTheSameNameEndsTheProgram) {
  const auto none = []() -> std::unique_ptr<Platform> { return nullptr; };
  EXPECT_EXIT(Platforms::add("twice", none) && Platforms::add("twice", none), testing::ExitedWithCode(2),
              "^two platforms with the name twice are linked into this program\n$");
}

}  // namespace
}  // namespace plumbline
