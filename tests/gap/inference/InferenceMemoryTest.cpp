#include "gap/inference/InferenceMemory.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>

#include "../TwoJointArm.h"

namespace plumbline::gap {
namespace {

const std::vector<double> awkward = {1.0 / 3, -0.0, 5e-324, -1.7976931348623157e308, 0.1 + 0.2};

class InferenceMemoryTest : public ::testing::Test {
protected:
  InferenceMemoryTest() { std::filesystem::remove(path); }
  ~InferenceMemoryTest() override { std::filesystem::remove(path); }

  static Scored setOf(const Explanation& causes, std::vector<double> gain) {
    Scored set;
    set.fitted.causes = causes;
    set.without.assign(gain.size(), causes);
    set.gain = std::move(gain);
    set.price = std::nextafter(2.0, 3.0);
    return set;
  }

  /// Of one cause, in five groups.
  static StoredSearch search() {
    const Cause one = causeOfArm("viscous_friction", "elbow", 0.1 + 0.2);
    Cause other = causeOfArm("backlash", "shoulder", 1.0 / 3);
    other.variant = 1;
    StoredSearch of;
    of.found.sets = {setOf({one}, awkward), setOf({other, one}, {1, 2, 3, 4, 5}), setOf({}, {0, 0, 0, 0, 0})};
    of.found.sets[1].without[3][0].value = std::nextafter(1.0 / 3, 1);
    of.found.lessOne = {setOf({}, {std::numeric_limits<double>::infinity(), -HUGE_VAL, 0, 1, 2})};
    of.found.kinds = 37;
    of.replays = 12345;
    return of;
  }

  static void expectSame(const std::vector<Scored>& a, const std::vector<Scored>& b) {
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].causes(), b[i].causes());
      EXPECT_EQ(a[i].without, b[i].without);
      EXPECT_EQ(a[i].price, b[i].price);
      ASSERT_EQ(a[i].gain.size(), b[i].gain.size());
      for (std::size_t g = 0; g < a[i].gain.size(); ++g)
        EXPECT_EQ(std::bit_cast<std::uint64_t>(a[i].gain[g]), std::bit_cast<std::uint64_t>(b[i].gain[g]));
    }
  }

  /// A file whose searches are this.
  void put(const nlohmann::json& searches) const {
    MemoryFile(path, "mark", {}).write({{"searches", searches}, {"values", nlohmann::json::object()}});
  }
  nlohmann::json stored() const {
    nlohmann::json found;
    MemoryFile(path, "mark", {}).read([&](const nlohmann::json& content) { found = content; });
    return found.at("searches");
  }
  std::size_t sizeRead() const { return InferenceMemory(path, "mark", arm).size(); }

  const Mechanism arm = twoJointArm();
  const std::string path = ::testing::TempDir() + "plumbline-inference-memory";
};

TEST_F(InferenceMemoryTest, givesBackSearchesAndValuesToTheLastBit) {
  const Explanation values{causeOfArm("coulomb_friction", "elbow", 1e-3 / 7),
                           causeOfArm("coulomb_friction", "shoulder", 2e-3 / 7)};
  {
    InferenceMemory memory(path, "mark", arm);
    EXPECT_EQ(memory.size(), 0u);
    memory.keep("sets", search());
    EXPECT_EQ(memory.sizeText(), "1 search done");
    memory.keep("sets again", search());
    memory.keep("values", StoredValues{values, 7});
  }
  const InferenceMemory again(path, "mark", arm);
  EXPECT_EQ(again.size(), 3u);
  EXPECT_EQ(again.sizeText(), "2 searches and 1 fit done");
  const StoredSearch* found = again.search("sets", 5);
  ASSERT_NE(found, nullptr);
  expectSame(found->found.sets, search().found.sets);
  expectSame(found->found.lessOne, search().found.lessOne);
  EXPECT_EQ(found->found.kinds, 37u);
  EXPECT_EQ(found->replays, 12345u);
  ASSERT_NE(again.values("values"), nullptr);
  EXPECT_EQ(again.values("values")->causes, values);
  EXPECT_EQ(again.values("values")->replays, 7u);
  EXPECT_EQ(again.search("values", 5), nullptr);
  EXPECT_EQ(again.values("sets"), nullptr);
  // A search that is to judge by other groups is another search.
  EXPECT_EQ(again.search("sets", 4), nullptr);
}

TEST_F(InferenceMemoryTest, givesBackACauseAtEveryPlace) {
  Explanation all;
  for (const Effect* effect : effects())
    for (const Place& place : placesOf(*effect, arm))
      for (int variant = 0; variant < effect->numVariants(); ++variant)
        all.push_back({effect, place, 0.1 / static_cast<double>(all.size() + 1), variant, {}});
  InferenceMemory(path, "mark", arm).keep("all", StoredValues{all, 0});
  EXPECT_EQ(InferenceMemory(path, "mark", arm).values("all")->causes, all);
}

TEST_F(InferenceMemoryTest, aFileThatHoldsNoSearchesIsNotTaken) {
  InferenceMemory(path, "mark", arm).keep("sets", search());
  const nlohmann::json good = stored();
  EXPECT_EQ(InferenceMemory(path, "other", arm).size(), 0u);
  using Change = std::function<void(nlohmann::json&)>;
  const std::vector<std::pair<const char*, Change>> changes = {
      {"no sets", [](nlohmann::json& j) { j["sets"] = nlohmann::json::array(); }},
      {"no price", [](nlohmann::json& j) { j["sets"][0].erase("price"); }},
      {"a form that is not there", [](nlohmann::json& j) { j["sets"][0]["causes"][0][0] = 9; }},
      {"a form before the first", [](nlohmann::json& j) { j["sets"][0]["causes"][0][0] = -1; }},
      {"a count that is none", [](nlohmann::json& j) { j["kinds"] = 1e300; }},
      {"an unknown effect", [](nlohmann::json& j) { j["forms"][0][0] = "none"; }},
      {"an unknown place", [](nlohmann::json& j) { j["forms"][0][1] = "none"; }},
      {"an unknown variant", [](nlohmann::json& j) { j["forms"][0][3] = 77; }},
      {"a number that is none", [](nlohmann::json& j) { j["sets"][0]["price"] = "many"; }},
      {"one gain too few", [](nlohmann::json& j) { j["sets"][0]["gain"].erase(0); }},
      {"a group less",
       [](nlohmann::json& j) { j["sets"][1]["gain"].erase(0), j["sets"][1]["without"].erase(0); }},
      {"a cause less in a group", [](nlohmann::json& j) { j["sets"][0]["without"][0].erase(0); }},
      {"nothing without the cause", [](nlohmann::json& j) { j["less_one"].erase(0); }}};
  for (const auto& [name, change] : changes) {
    nlohmann::json bad = good;
    change(bad["sets"]);
    put(bad);
    EXPECT_EQ(sizeRead(), 0u) << name;
  }
  put(good);
  EXPECT_EQ(sizeRead(), 1u);
}

TEST_F(InferenceMemoryTest, withoutADiskItGoesOn) {
  std::vector<std::string> problems;
  InferenceMemory memory("/proc/none/searches", "mark", arm,
                         [&](const std::string& problem) { problems.push_back(problem); });
  memory.keep("sets", search());
  memory.keep("more", search());
  EXPECT_EQ(problems, std::vector<std::string>{
                          "cannot write /proc/none/searches: No such file or directory; a diagnosis "
                          "that is stopped from now on repeats what follows"});
  EXPECT_EQ(memory.size(), 0u);
}

}  // namespace
}  // namespace plumbline::gap
