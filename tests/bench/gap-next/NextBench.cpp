// Does the motion that bin/gap next proposes decide between two explanations? A robot in Bullet has one
// effect of a size at which one recording leaves it and another explanation both likely. Then bin/gap next
// designs a motion for the two, the robot plays it, and both explanations are fitted to both recordings.
// Beside it: another motion of the battery, drawn at random. Environment: PAIRS [30], SEED [2], JOBS [1].
// Pairs that are done are kept in build/bench/gap-next-SEED/. Writes build/bench/gap-next.json and .md.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "OpenPair.h"
#include "framework/WriteFile.h"
#include "gap/blind/ScoreJudge.h"
#include "support/Environment.h"
#include "support/FigureJson.h"

using namespace plumbline;
using namespace plumbline::gap;
using namespace plumbline::bench;
using nlohmann::json;

namespace {

json figure(const std::string& name, double value, const char* unit, const char* better) {
  return figureJson("gap-next." + name, value, unit, better);
}

/// Pairs that a kind of motion decided rightly and wrongly; the others stay open.
struct Tally {
  std::size_t right = 0, wrong = 0;
  void add(double odds) {
    right += odds > decided;
    wrong += odds < -decided;
  }
};

void write(const std::vector<Pair>& pairs, std::uint64_t seed) {
  Tally proposed, random;
  std::size_t draws = 0, inseparable = 0;
  std::string rows;
  for (const Pair& pair : pairs) {
    proposed.add(pair.withProposed);
    random.add(pair.withRandom);
    draws += pair.draws;
    inseparable += pair.inseparable;
    char numbers[160];
    std::snprintf(numbers, sizeof numbers, "%+.1f | %s | %+.1f | %s | %+.1f", pair.before,
                  pair.proposed.c_str(), pair.withProposed, pair.random.c_str(), pair.withRandom);
    rows += "| " + pair.robot + " | " + pair.truth + " | " + pair.rival + " | " + pair.first + " | " +
            numbers + " |\n";
  }
  const Figure p = share("", "", proposed.right, pairs.size()), r = share("", "", random.right, pairs.size());
  char text[2400];
  std::snprintf(
      text, sizeof text,
      "%zu pairs, seed %llu. A robot in Bullet has one effect. It is drawn and then weakened until one "
      "recording (a motion of the battery) still shows it, but cannot decide between it and its nearest "
      "rival (odds below %.0f to "
      "1, log odds below "
      "%.0f). %zu draws were needed. `bin/gap next` gets the two fitted explanations. The same robot plays "
      "its motion with the library's recorder, and both explanations are fitted to both recordings. Decided: "
      "odds "
      "of more than %.0f to 1 "
      "for the true effect. For %zu further pairs `bin/gap next` said that no motion separates them (for "
      "example a servo's own damping and viscous friction if nothing saturates); other pairs were drawn "
      "instead. Seven pairs of seed 1 were known when motions near the stops were added to the designs (five "
      "were decided); no other seed was known.\n\n"
      "The proposed motion decides **%zu of %zu** (95 %%: %.2f to %.2f), wrongly %zu; the others "
      "stay open. Another motion "
      "of the battery, drawn at random, decides %zu (%.2f to %.2f), wrongly %zu.\n\n"
      "| robot | in it | rival | first motion | log odds before | proposed motion | with it | at "
      "random | with it |\n"
      "|---|---|---|---|---|---|---|---|---|\n",
      pairs.size(), static_cast<unsigned long long>(seed), std::exp(decided), decided, draws,
      std::exp(decided), inseparable, proposed.right, pairs.size(), p.lower, p.upper, proposed.wrong,
      random.right, r.lower, r.upper, random.wrong);
  writeFile("build/bench/gap-next.md", text + rows);
  json share = figure("decided_share", p.value, "1", "higher");
  share["target"] = 25.0 / 30;
  const json figures = {figure("pairs", static_cast<double>(pairs.size()), "1", "higher"), share,
                        figure("said_inseparable", static_cast<double>(inseparable), "1", "lower"),
                        figure("decided_wrongly", static_cast<double>(proposed.wrong), "1", "lower"),
                        figure("random_motion_decides_share", r.value, "1", "higher")};
  writeFile("build/bench/gap-next.json", figures.dump(1) + "\n");
}

}  // namespace

int main() try {
  const std::uint64_t seed = environment("SEED", 2);
  const auto count = std::clamp<std::uint64_t>(environment("PAIRS", 30), 1, 1000);
  const auto jobs = static_cast<int>(std::clamp<std::uint64_t>(environment("JOBS", 1), 1, 256));
  const std::string folder = "build/bench/gap-next-" + std::to_string(seed);
  std::filesystem::create_directories(folder);
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < count; ++i) {
    pairs.push_back(pairOf(folder, i, seed, jobs));
    std::printf("%zu/%llu %s or %s: %+.1f, with %s %+.1f\n", i + 1, static_cast<unsigned long long>(count),
                pairs.back().truth.c_str(), pairs.back().rival.c_str(), pairs.back().before,
                pairs.back().proposed.c_str(), pairs.back().withProposed);
    std::fflush(stdout);
    write(pairs, seed);
  }
} catch (const std::exception& error) {
  std::fprintf(stderr, "bench gap-next: %s\n", error.what());
  return 2;
}
