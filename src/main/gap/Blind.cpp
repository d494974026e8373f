// bin/gap blind: benchmarks whose answers are sealed, and how well answers do on them.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "framework/ConfigFolder.h"
#include "framework/Parallel.h"
#include "gap/blind/BeyondReference.h"
#include "gap/blind/BlindScore.h"
#include "gap/blind/CaseText.h"
#include "gap/blind/Make.h"
#include "gap/blind/PlantedSet.h"
#include "main/gap/Commands.h"
#include "main/gap/ProgressLine.h"
#include "robot/MechanismFile.h"
#include "servo/RobotSimulation.h"

namespace plumbline::gap {

namespace {

struct ScoreCommand {
  std::string folder, answers;
  std::string list;  ///< wrong, all; empty: figures alone
  bool json = false;
};

void make(BlindMakeOptions options, const std::string& battery) {
  options.draw.battery = battery == "all" ? Battery::all : Battery::hang;
  options.jobs = threadsFor(options.jobs);
  // The tree's own program is found from any folder.
  if (options.program == BlindMakeOptions().program && !std::filesystem::exists(options.program))
    if (const auto inTree = std::filesystem::path(programFolder()) / ".." / options.program;
        std::filesystem::exists(inTree))
      options.program = inTree.lexically_normal().string();
  ProgressLine line(false);
  line.update("cases", 0);
  options.progress = [&](std::size_t done) {
    line.update("cases", static_cast<double>(done) / static_cast<double>(options.draw.cases));
    std::printf("%zu/%zu\n", done, options.draw.cases);
    std::fflush(stdout);
  };
  const BlindSet set = makeBlind(options);
  std::printf("%zu cases written to %s; their answers are in answers.sealed, not to be read by accident\n",
              set.cases.size(), options.output.c_str());
  if (options.engine == blindReplay)
    std::printf("Without effects outside the library: engine replay has none\n");
}

void plant(const BlindMakeOptions& options, std::vector<std::string> from, bool robotGiven) {
  PlantedSetOptions planting{std::move(from),    robotGiven ? options.robot : "",
                             options.draw.cases, options.draw.seed,
                             options.output,     threadsFor(options.jobs)};
  ProgressLine line(false);
  line.update("cases", 0);
  planting.progress = [&](std::size_t done) {
    line.update("cases", static_cast<double>(done) / static_cast<double>(planting.cases));
    std::printf("%zu/%zu\n", done, planting.cases);
    std::fflush(stdout);
  };
  std::vector<RunWarning> warnings;
  const BlindSet set = makePlantedSet(planting, warnings);
  for (const RunWarning& warning : warnings)
    std::fprintf(stderr, "gap: %s\n", warning.line(set.robot).c_str());
  std::printf(
      "%zu cases written to %s; their answers are in answers.sealed, not to be read by accident\n"
      "Each has its own model: bin/gap diagnose CASE --robot CASE/robot.json\n",
      set.cases.size(), options.output.c_str());
}

void score(const ScoreCommand& options) {
  const BlindSet set = readSealed(options.folder);
  const bool recorded = set.fromRecordings() && !set.cases.empty();
  const Mechanism robot =
      recorded ? readMechanism(
                     (std::filesystem::path(options.folder) / set.cases.front().name / "robot.json").string())
               : namedMechanism(set.robot);
  std::vector<BlindAnswer> answers = readAnswers(set, options.answers);
  if (recorded) answers = beyondReference(set, std::move(answers), robot);
  const BlindScore result = scoreBlind(set, answers, robot);
  std::fputs((options.json ? scoreJson(result) + "\n" : scoreTable(result)).c_str(), stdout);
  if (!options.list.empty())
    std::fputs(("\n" + caseList(set, answers, robot, options.list == "all")).c_str(), stdout);
}

}  // namespace

void addBlind(CommandLine& app) {
  CommandLine command = app.command("blind", "Makes sealed benchmarks and scores answers to them");
  command.requireCommand();
  command.footer(
      "Examples:\n  bin/gap blind make --seed 5 --cases 27 --engine bullet -o blind\n"
      "  bin/gap blind make --from runs --cases 20 -o planted\n"
      "  bin/gap blind score blind answers");

  CommandLine maker = command.command("make", "Writes cases whose answers are sealed apart");
  auto making = std::make_shared<BlindMakeOptions>();
  auto battery = std::make_shared<std::string>("hang");
  maker.option("--seed", making->draw.seed, "Draws effects, places, sizes and noise").showDefault();
  maker.option("--cases", making->draw.cases, "How many").range(1, 10000).showDefault();
  auto from = std::make_shared<std::vector<std::string>>();
  maker.option("--from", *from,
               "Recordings of one real robot, its base fixed: causes are planted in these, instead of a "
               "simulated reality");
  maker
      .option(
          "--engine", making->engine,
          fmt::format("What simulates the reality: an engine of this program ({}), replay (the diagnosis' "
                      "own dynamics), or program (a separate one: --engine-program)",
                      fmt::join(servo::RobotSimulations::names(), ", ")))
      .showDefault();
  maker.option("--battery", *battery, "Motions: hung up, or on the feet as well")
      .oneOf({"hang", "all"})
      .showDefault();
  maker.option("--engine-program", making->program, "The program of engine program").showDefault();
  maker.option("--robot", making->robot, "Name in config/robots, or a robot's file").showDefault();
  maker.option("--jobs", making->jobs, "Cases made at a time [as many as cores]").range(1, 256);
  making->jobs = 0;
  maker.option("-o,--output", making->output, "A new folder").required();
  maker.footer(
      "Examples:\n  bin/gap blind make --seed 5 --cases 27 --engine bullet -o blind\n"
      "  bin/gap blind make --from runs --robot my_leg.urdf --seed 5 --cases 20 -o planted");
  maker.whenChosen([=] {
    if (from->empty()) return make(*making, *battery);
    for (const char* option : {"--engine", "--engine-program", "--battery"})
      if (maker.given(option))
        throw std::invalid_argument(std::string("--from excludes ") + option +
                                    ": the reality is in the recordings");
    plant(*making, *from, maker.given("--robot"));
  });

  CommandLine scorer = command.command("score", "Compares answers with the sealed effects");
  auto scoring = std::make_shared<ScoreCommand>();
  scorer.option("folder", scoring->folder, "What blind make wrote").required();
  scorer
      .option("answers", scoring->answers,
              "Folder with one <case>.json per case, as bin/gap diagnose FOLDER/<case> --json writes it")
      .required();
  const CommandOption list =
      scorer
          .option("--list", scoring->list,
                  "Prints what cases hid and what was said of them: those answered wrongly, or all")
          .oneOf({"wrong", "all"});
  scorer.flag("--json", scoring->json, "The figures as JSON").excludes(list);
  scorer.footer(
      "Examples:\n  bin/gap blind score blind answers\n  bin/gap blind score blind answers --list wrong");
  scorer.whenChosen([=] { score(*scoring); });
}

}  // namespace plumbline::gap
