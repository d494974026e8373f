#include "framework/OutputGuard.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

#include "framework/Controller.h"
#include "framework/LogBuffer.h"
#include "framework/Module.h"

namespace plumbline {

REPRESENTATION(Drift)
class Drift : public DriftBase {
public:
  double sum = 0;
  std::vector<float> trail;
  void stream(InStream* in, OutStream* out) override {
    STREAM(sum);
    STREAM(trail);
  }
};

REPRESENTATION(DriftSeen)
class DriftSeen : public DriftSeenBase {
public:
  double sum = 0;
  std::string problem() const { return sum < 100 ? "" : "sum: must be below 100"; }
  void stream(InStream* in, OutStream* out) override { STREAM(sum); }
};

namespace {
double fault = 0;  ///< added in the next cycles
int made = 0;
}  // namespace

MODULE(DriftSource)
  PROVIDES(Drift)
END_MODULE
/// Adds up what comes: a number that is not finite would stay in it for ever.
class DriftSource : public DriftSourceBase {
public:
  void init() override { ++made; }
  void update(Drift* theDrift) override {
    sum_ += 1 + fault;
    theDrift->sum = sum_;
    theDrift->trail.assign(2, static_cast<float>(sum_));
  }

private:
  double sum_ = 0;
};
MAKE_MODULE(DriftSource)

MODULE(DriftReader)
  REQUIRES(Drift)
  PROVIDES(DriftSeen)
END_MODULE
class DriftReader : public DriftReaderBase {
public:
  void update(DriftSeen* theDriftSeen) override { theDriftSeen->sum = theDrift->sum; }
};
MAKE_MODULE(DriftReader)

namespace {

TEST(OutputGuard, keepsTheLastGoodValueAndStartsTheModuleAnew) {
  std::string said;
  LogBuffer::instance().setListener(
      [&](std::string_view, std::string_view message) { said += std::string(message) + '\n'; });
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    made = 0;
    fault = 0;
    said.clear();
    Controller controller(ControllerOptions{}, "DriftSource Drift\nDriftReader DriftSeen\n");
    controller.runCycles(3);
    EXPECT_EQ(controller.find<DriftSeen>()->sum, 3);
    fault = bad;
    controller.runCycles(1);
    EXPECT_EQ(controller.find<DriftSeen>()->sum, 3) << "the reader sees the last good value";
    EXPECT_EQ(controller.find<Drift>()->trail, std::vector<float>(2, 3.0F));
    EXPECT_EQ(made, 2) << "the source starts anew, the reader does not";
    EXPECT_NE(said.find("DriftSource:updateDrift: sum: must be finite, not "), std::string::npos) << said;
    fault = 0;
    controller.runCycles(1);
    EXPECT_EQ(controller.find<DriftSeen>()->sum, 1);
  }
  LogBuffer::instance().setListener(nullptr);
}

TEST(OutputGuard, holdsAModuleToTheRepresentationsOwnCheck) {
  DriftSeen seen;
  OutputGuard guard(representationLoader<DriftSeen>(), seen);
  seen.sum = 99;
  EXPECT_EQ(guard.check(), "");
  seen.sum = 100;
  EXPECT_EQ(guard.check(), "sum: must be below 100");
  EXPECT_EQ(seen.sum, 99) << "the last good value";
}

TEST(OutputGuard, aValueThatStaysIsWrongUntilItChanges) {
  DriftSeen seen;
  seen.sum = 200;
  OutputGuard guard(representationLoader<DriftSeen>(), seen);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(guard.check(), "sum: must be below 100");
  seen.sum = 5;
  for (int i = 0; i < 3; ++i) EXPECT_EQ(guard.check(), "");
  seen.sum = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(guard.check(), "sum: must be finite, not nan");
  EXPECT_EQ(seen.sum, 5);
}

TEST(OutputGuard, looksAtEveryStreamedNumber) {
  Drift drift;
  bool numbers = false;
  EXPECT_TRUE(streamsFiniteNumbers(drift, numbers));
  EXPECT_TRUE(numbers);
  drift.trail = {1, 2, std::numeric_limits<float>::infinity()};
  EXPECT_FALSE(streamsFiniteNumbers(drift, numbers));
}

}  // namespace
}  // namespace plumbline
