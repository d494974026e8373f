#include "optimization/farm/Journal.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "../Functions.h"
#include "optimization/Cmaes.h"

namespace plumbline::farm {
namespace {

using Eigen::VectorXd;

class JournalTest : public testing::Test {
protected:
  JournalTest() {
    folder = std::filesystem::temp_directory_path() / ("journal" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    path = folder / "evaluations.jsonl";
  }
  ~JournalTest() override { std::filesystem::remove_all(folder); }

  static Search keptSearch() {
    CmaesOptions options;
    options.population = 6;
    options.ahead = 2;
    options.stop.maxGenerations = 12;
    return {std::make_unique<Cmaes>(SearchSpace::around(VectorXd::Constant(3, 1), 0.5), options),
            Averaging{1, 2}, 3};
  }
  static void tell(Search& search_, const JournalEntry& entry) {
    if (entry.givenUp)
      search_.giveUp(entry.number);
    else
      search_.tell(entry.number, entry.costs);
  }
  /// Evaluates so many trials; every seventh is no number, every eleventh is given up.
  static void work(Search& search_, Journal& journal, int trials) {
    for (int i = 0; i < trials && !search_.isDone(); ++i) {
      const Trial trial = *search_.next();
      std::vector<double> costs(trial.seeds.size(), sphere(trial.parameters));
      if (trial.number / 2 % 7 == 3) costs[0] = std::nan("");
      if (trial.number / 2 % 11 == 5) costs.clear();
      journal.add(trial, costs, {{"height", 0.25}}, "worker", 1.5);
      if (costs.empty())
        search_.giveUp(trial.number);
      else
        search_.tell(trial.number, costs);
    }
  }
  std::string errorOf(const std::string& mark) {
    try {
      Journal journal(path, mark, [](const JournalEntry&) {});
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "no error";
  }

  std::filesystem::path folder;
  std::string path;
};

// What is behind a line that cannot be read would be cut off otherwise.
TEST_F(JournalTest, aFileThatCannotBeReadStaysAsItIs) {
  path = "/proc/self/mem";
  EXPECT_EQ(errorOf("mark"), "/proc/self/mem: cannot be read: Input/output error");
}

TEST_F(JournalTest, aSearchThatIsKilledAnywhereEndsAsIfItHadNotBeen) {
  Search undisturbed = keptSearch();
  {
    Journal journal(folder / "other.jsonl", "mark", [](const JournalEntry&) {});
    work(undisturbed, journal, 100000);
  }
  for (int lives = 0; lives < 100; ++lives) {
    Search again = keptSearch();
    Journal journal(path, "mark", [&](const JournalEntry& entry) { tell(again, entry); });
    work(again, journal, 3);
    if (!again.isDone()) continue;
    EXPECT_GT(lives, 20);
    EXPECT_TRUE(again.optimizer().save() == undisturbed.optimizer().save());
    EXPECT_EQ(again.trials(), undisturbed.trials());
    EXPECT_EQ(again.notNumbers(), undisturbed.notNumbers());
    EXPECT_EQ(again.givenUp(), undisturbed.givenUp());
    return;
  }
  FAIL() << "it never ended";
}

TEST_F(JournalTest, aLineThatWasCutIsDropped) {
  {
    Search one = keptSearch();
    Journal journal(path, "mark", [](const JournalEntry&) {});
    work(one, journal, 5);
  }
  std::filesystem::resize_file(path, std::filesystem::file_size(path) - 4);
  int entries = 0;
  {
    Journal journal(path, "mark", [&](const JournalEntry&) { ++entries; });
    EXPECT_EQ(journal.resumed(), 4);
  }
  EXPECT_EQ(entries, 4);
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(text.back(), '\n') << "the next line begins on its own";
}

TEST_F(JournalTest, whatCannotBeGoneOnWithIsSaid) {
  EXPECT_EQ(errorOf("mark"), "no error");
  EXPECT_EQ(errorOf("another"),
            path +
                ":1: the results of another search (its options, task or program differ); take "
                "another folder or remove this one");
  std::ofstream(path, std::ios::app) << "{\"trial\": 1}\n";
  EXPECT_EQ(errorOf("mark"), path + ":2: no result; remove the line and all below it to continue from there");
  const Journal held(folder / "held.jsonl", "mark", [](const JournalEntry&) {});
  path = folder / "held.jsonl";
  EXPECT_EQ(errorOf("mark"), path + ": another server writes it; end that one or take another folder");
}

}  // namespace
}  // namespace plumbline::farm
