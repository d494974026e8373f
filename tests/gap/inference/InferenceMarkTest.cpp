#include "gap/inference/InferenceMark.h"

#include <gtest/gtest.h>

#include <functional>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

class InferenceMarkTest : public ::testing::Test {
protected:
  static std::string markWith(const std::function<void(Mechanism&)>& change,
                              const std::function<void(std::vector<Trial>&)>& changeTrials = {},
                              const InferenceOptions& options = {}) {
    Mechanism arm = twoJointArm();
    std::vector<Trial> trials{recorded(nominalPlant(arm), armTrial(arm, 1), 5e-4, 3),
                              recorded(nominalPlant(arm), armTrial(arm, 1), 5e-4, 4)};
    if (change) change(arm);
    if (changeTrials) changeTrials(trials);
    return markOf(arm, trials, options);
  }
  const std::string mark = markWith({});
};

TEST_F(InferenceMarkTest, isTheSameForTheSame) {
  EXPECT_EQ(markWith({}), mark);
  InferenceOptions options;
  options.jobs = 7;  // decides nothing
  options.progress = [](const std::string&, double) {};
  EXPECT_EQ(markWith({}, {}, options), mark);
}

TEST_F(InferenceMarkTest, coversModelRecordingsAndOptions) {
  EXPECT_NE(markWith([](Mechanism& arm) { arm.links[2].mass *= 1.1; }), mark);
  EXPECT_NE(markWith([](Mechanism& arm) { arm.joints[0].servo.kp *= 1.1; }), mark);
  using Change = std::function<void(std::vector<Trial>&)>;
  const std::vector<std::pair<const char*, Change>> changes = {
      {"a command", [](std::vector<Trial>& t) { t[0].command[0][50] += 1e-9; }},
      {"a reading", [](std::vector<Trial>& t) { t[1].signals[1].values[50] += 1e-9; }},
      {"when commands arrive", [](std::vector<Trial>& t) { t[1].commandAt[1] += 0.001; }},
      {"which recording it is", [](std::vector<Trial>& t) { t[1].recording = t[0].recording + "x"; }},
      {"the order", [](std::vector<Trial>& t) { std::swap(t[0], t[1]); }},
      {"a recording less", [](std::vector<Trial>& t) { t.pop_back(); }}};
  for (const auto& [name, change] : changes) EXPECT_NE(markWith({}, change), mark) << name;
  InferenceOptions options;
  options.mostCauses = 2;
  EXPECT_NE(markWith({}, {}, options), mark);
}

}  // namespace
}  // namespace plumbline::gap
