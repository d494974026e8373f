#include <gtest/gtest.h>

#include <thread>

#include "framework/TestModules.h"
#include "framework/TimingPlugin.h"

// Copies between the threads of an agent, from modules.cfg to the pointer in the module.
namespace plumbline {

REPRESENTATION(Stamp)
class Stamp : public StampBase {
public:
  std::array<std::uint64_t, 100> cycle{};
  void stream(InStream* in, OutStream* out) override { STREAM(cycle); }
};

/// The same number as Stamp of the same cycle.
REPRESENTATION(StampEcho)
class StampEcho : public StampEchoBase {
public:
  std::uint64_t cycle = 0;
};

MODULE(StampSource)
  PROVIDES(Stamp)
  PROVIDES(StampEcho)
END_MODULE
class StampSource : public StampSourceBase {
public:
  void execute() override { cycle_++; }
  void update(Stamp* theStamp) override { theStamp->cycle.fill(cycle_); }
  void update(StampEcho* theStampEcho) override { theStampEcho->cycle = cycle_; }

private:
  std::uint64_t cycle_ = 0;
};
MAKE_MODULE(StampSource)

/// Ends the agent with 0 after enough good copies and with 1 at the first bad one.
MODULE(StampChecker)
  REQUIRES(Stamp)
  REQUIRES(StampEcho)
END_MODULE
class StampChecker : public StampCheckerBase {
public:
  void execute() override {
    for (const std::uint64_t cycle : theStamp->cycle) {
      if (cycle != theStamp->cycle[0]) return requestStop(1, "torn");
    }
    if (theStampEcho->cycle != theStamp->cycle[0]) return requestStop(1, "of two cycles");
    if (theStamp->cycle[0] < last_) return requestStop(1, "went back");
    if (theStamp->cycle[0] == last_) std::this_thread::yield();  // others may need the processor
    changes_ += theStamp->cycle[0] != last_;
    last_ = theStamp->cycle[0];
    if (changes_ == 100) requestStop(0, "100 new copies were whole");
  }

private:
  std::uint64_t last_ = 0;
  int changes_ = 0;
};
MAKE_MODULE(StampChecker)

namespace {

TEST(ThreadsTest, copiesAreWholeAndOfOneCycle) {
  Controller controller = makeController(
      "[source 1]\nStampSource Stamp\nStampSource StampEcho\n"
      "[checker 1]\nsource Stamp\nsource StampEcho\nStampChecker\n");
  EXPECT_EQ(controller.run(), 0);
  EXPECT_EQ(controller.stop().reason(), "100 new copies were whole");
}

TEST(ThreadsTest, copiesOfCopiesArrive) {
  Controller controller = makeController(
      "[source 1]\nStampSource Stamp\nStampSource StampEcho\n"
      "[between 1]\nsource Stamp\nsource StampEcho\nOptionalReader\n"
      "[checker 1]\nbetween Stamp\nbetween StampEcho\nStampChecker\n");
  EXPECT_EQ(controller.run(), 0);
  EXPECT_EQ(controller.stop().reason(), "100 new copies were whole");
}

}  // namespace
}  // namespace plumbline
