// bin/learnvalue: learns what a ball is worth by where it is and who is nearer to it, from the tracks of
// games.
#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <vector>

#include "framework/CommandLine.h"
#include "framework/GuardedMain.h"
#include "framework/StopSignal.h"
#include "framework/WriteFile.h"
#include "watch/LearnFromTrack.h"

namespace {

using namespace plumbline;

FieldGrid standardGrid() {
  std::vector<double> x;
  for (int i = -7; i <= 7; ++i) x.push_back(2 * i);
  return FieldGrid(std::move(x), {0, 3, 6, 9});
}

int runProgram(int argc, char** argv) {
  std::vector<std::string> tracks;
  std::string output = "config/field_value.yaml";
  FieldValueLearner::Options options;
  CommandLine app(
      "Learns the value of the field from games: config/field_value.yaml, by which a striker decides.",
      "learnvalue");
  app.option("tracks", tracks,
             "track.csv of games between equal teams (scripts/autoplay, bin/watchgame --track)")
      .required()
      .existingFile();
  app.option("-o,--output", output, "The file to write").showDefault();
  app.option("--prior", options.priorSteps, "Steps of a ball that rolls to and fro, assumed at each point")
      .range(1e-3, 1e6)
      .showDefault();
  app.footer("Example:\n  bin/learnvalue build/games/*/*/track.csv -o config/field_value.yaml");
  if (const auto status = readCommandLine(app, argc, argv)) return *status;
  StopSignal stop;
  stop.catchSignals();
  FieldValueLearner learner(standardGrid(), options);
  for (const std::string& track : tracks) watch::learnFromTrack(watch::readTrack(track), learner);
  if (learner.steps() == 0)
    throw std::runtime_error("no ball in play in " + fmt::format("{} tracks", tracks.size()));
  const std::string head = fmt::format(
      "# What a ball is worth: the probability that the next goal is ours less that it is theirs, by its "
      "place\n"
      "# (x towards the opponents' goal; y aside, both sides alike; metres) and who is nearer to it\n"
      "# (src/tactics/FieldValue.h). Learnt by bin/learnvalue from {} games: {} steps of {:g} s, {} of\n"
      "# them into a goal.\n",
      tracks.size(), learner.steps(), watch::learningStep, learner.goals());
  writeFile(output, head + learner.learn().yaml());
  fmt::print("{} games, {} steps, {} of them into a goal: {}\n", tracks.size(), learner.steps(),
             learner.goals(), output);
  return 0;
}

}  // namespace

int main(int argc, char** argv) { return plumbline::guardedMain("learnvalue", runProgram, argc, argv); }
