// Modules that are made anew while the agent runs: what stays, what begins again, what is refused.
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <limits>

#include "framework/AgentDebug.h"
#include "framework/Controller.h"
#include "framework/Module.h"
#include "support/Thrown.h"

namespace plumbline {

REPRESENTATION(LifeOutput)
class LifeOutput : public LifeOutputBase {
public:
  double sum = 0, speed = 0, step = 0;
  void stream(InStream* in, OutStream* out) override {
    STREAM(sum);
    STREAM(speed);
    STREAM(step);
  }
};

/// Sums a parameter; nothing of its file but parameters.
MODULE(LifeSummer)
  PROVIDES(LifeOutput)
  PARAMETER(double, speed, 1, "", Range(0, 10), "added in each cycle")
  PARAMETER(double, step, 0, "", Range(0, 10), "added, too")
END_MODULE
class LifeSummer : public LifeSummerBase {
public:
  static inline bool broken = false;
  void update(LifeOutput* theLifeOutput) override {
    theLifeOutput->sum = broken ? std::numeric_limits<double>::quiet_NaN() : sum_ += speed + step;
    theLifeOutput->speed = speed;
    theLifeOutput->step = step;
    broken = false;
  }

private:
  double sum_ = 0;
};
MAKE_MODULE(LifeSummer)

REPRESENTATION(LifeRead)
class LifeRead : public LifeReadBase {
public:
  double height = 0;
  int cycles = 0;
  void stream(InStream* in, OutStream* out) override {
    STREAM(height);
    STREAM(cycles);
  }
};
/// Reads a file itself.
MODULE(LifeReader)
  PROVIDES(LifeRead)
END_MODULE
class LifeReader : public LifeReaderBase {
public:
  void init() override { height_ = config.file("life").get<double>("height", {0, 2}); }
  void update(LifeRead* theLifeRead) override {
    theLifeRead->height = height_;
    theLifeRead->cycles = ++cycles_;
  }

private:
  double height_ = 0;
  int cycles_ = 0;
};
MAKE_MODULE(LifeReader)

namespace {

/// Wants a thing once at a point, as the debug interface does.
class Ask final : public DebugRequest {
public:
  explicit Ask(double value = 0) : value_(value) {}
  void serve(DebugValue& value) noexcept override {
    if (done) return;
    done = true;
    struct In final : InStream {
      double number;
      explicit In(double n) : number(n) {}
      void readSigned(std::int64_t&, unsigned) override {}
      void readUnsigned(std::uint64_t&, unsigned) override {}
      void readBool(bool&) override {}
      void readChar(char&) override {}
      void readFloat(float&) override {}
      void readDouble(double& v) override { v = number; }
      void readString(std::string&) override {}
      void readRaw(void*, std::size_t) override {}
      void beginObject() override {}
      void endObject() override {}
      void label(std::string_view) override {}
      void beginList() override {}
      bool nextElement() override { return false; }
      void endList() override {}
      std::size_t position() const override { return 0; }
    } in(value_);
    value.read(in);
  }
  bool run() noexcept override { return !std::exchange(done, true); }
  void output(std::string_view text) noexcept override { said = text; }
  void failed(std::string_view text) noexcept override { said = "failed: " + std::string(text); }
  bool done = false;
  std::string said;

private:
  double value_;
};

struct ModuleLifeTest : testing::Test {
  std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("life-" + std::to_string(getpid()));
  std::unique_ptr<Controller> controller;

  ModuleLifeTest() {
    std::filesystem::create_directories(folder);
    write("life", "height: 0.5\n");
    write("LifeSummer", "speed: 2\n");
    controller = std::make_unique<Controller>(ControllerOptions{"modules.cfg", {folder.string()}},
                                              "LifeSummer LifeOutput\nLifeReader LifeRead\n");
    controller->runCycles(3);
    controller->debug().setWatched(true);
  }
  ~ModuleLifeTest() override {
    controller.reset();
    std::filesystem::remove_all(folder);
  }
  std::string path(const std::string& name) { return (folder / (name + ".yaml")).string(); }
  void write(const std::string& name, const std::string& text) { std::ofstream(path(name)) << text; }
  /// What is said to who wants the point, in one cycle.
  std::string ask(const std::string& id, double value = 0) {
    const auto request = std::make_shared<Ask>(value);
    EXPECT_TRUE(controller->debug().points.attach(id, request)) << id;
    controller->runCycles(1);
    controller->debug().points.detach(id, request);
    EXPECT_TRUE(request->done);
    return request->said;
  }
  const LifeOutput& output() { return *controller->find<LifeOutput>(); }
  const LifeRead& read() { return *controller->find<LifeRead>(); }
};

TEST_F(ModuleLifeTest, aResetModuleForgetsAndKeepsWhatWasSet) {
  EXPECT_EQ(output().sum, 6);
  ask("config:LifeSummer.step", 5);
  EXPECT_EQ(output().sum, 13);
  EXPECT_EQ(ask("reset:LifeSummer"), "LifeSummer began anew");
  controller->runCycles(1);
  EXPECT_EQ(output().sum, 7);
  EXPECT_EQ(output().step, 5);
}

TEST_F(ModuleLifeTest, aModuleThatWasRemadeForABadNumberKeepsWhatWasSet) {
  ask("config:LifeSummer.step", 5);
  LifeSummer::broken = true;
  controller->runCycles(2);
  EXPECT_EQ(output().sum, 7);
}

TEST_F(ModuleLifeTest, parametersAreReloadedWithoutForgetting) {
  write("LifeSummer", "speed: 4\n");
  EXPECT_EQ(ask("reload:LifeSummer"), "LifeSummer goes on with it");
  EXPECT_EQ(output().sum, 8);
  controller->runCycles(1);
  EXPECT_EQ(output().sum, 12);
  std::filesystem::remove(path("LifeSummer"));
  ask("reload:LifeSummer");
  controller->runCycles(1);
  EXPECT_EQ(output().speed, 1);
}

TEST_F(ModuleLifeTest, whatWasSetCountsMoreThanTheFileUntilItIsUnset) {
  ask("config:LifeSummer.speed", 3);
  write("LifeSummer", "speed: 4\n");
  ask("reload:LifeSummer");
  controller->runCycles(1);
  EXPECT_EQ(output().speed, 3);
  ask("config:LifeSummer.speed", 4);  // as the file has it
  write("LifeSummer", "speed: 5\n");
  ask("reload:LifeSummer");
  controller->runCycles(1);
  EXPECT_EQ(output().speed, 5);
}

TEST_F(ModuleLifeTest, aModuleThatReadsItsFileItselfBeginsAnew) {
  write("life", "height: 1.5\n");
  EXPECT_EQ(ask("reload:life"), "LifeReader began anew");
  controller->runCycles(1);
  EXPECT_EQ(read().height, 1.5);
  EXPECT_EQ(read().cycles, 1);
}

TEST_F(ModuleLifeTest, aWrongFileIsRefusedWithItsLineAndTheOldStays) {
  write("life", "# a comment\nheight: 3\n");
  EXPECT_EQ(ask("reload:life"), "failed: " + path("life") + ":2: height must be within [0, 2], not 3");
  write("life", "height: 1\nweight: 3\n");
  EXPECT_EQ(ask("reload:life"),
            "failed: " + path("life") + ":2: unknown key \"weight\"; did you mean \"height\"?");
  write("LifeSummer", "speed: fast\n");
  EXPECT_TRUE(ask("reload:LifeSummer").starts_with("failed: " + path("LifeSummer") + ":1: "));
  std::filesystem::remove(path("life"));
  EXPECT_EQ(ask("reload:life"), "failed: no config file life.yaml in " + folder.string());
  controller->runCycles(1);
  EXPECT_EQ(read().height, 0.5);
  EXPECT_EQ(read().cycles, 8);
  EXPECT_EQ(output().speed, 2);
  // Mended, it is taken.
  write("life", "height: 1\n");
  ask("reload:life");
  controller->runCycles(1);
  EXPECT_EQ(read().height, 1);
}

TEST_F(ModuleLifeTest, whoProvidesWhatIsKnown) {
  const auto provisions = controller->debug().provisions();
  ASSERT_EQ(provisions.size(), 2u);
  EXPECT_EQ(provisions[0].representation + ' ' + provisions[0].provider + ' ' + provisions[0].thread,
            "LifeOutput LifeSummer default");
}

}  // namespace
}  // namespace plumbline
