// bin/gap: the sim-to-real diagnosis. Each subcommand stands in a file of its own.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "framework/CommandLine.h"
#include "framework/ConfigFolder.h"
#include "framework/GuardedMain.h"
#include "framework/StopSignal.h"
#include "main/gap/Commands.h"

namespace {

int run(int argc, char** argv) {
  using namespace plumbline;
  CLI::App app(
      "Finds what a simulator lacks: where it differs from a real robot, which unmodelled effect is the "
      "cause, "
      "and how far the gap shrinks once that effect is in.",
      "gap");
  app.require_subcommand(1);
  gap::addRecord(app);
  gap::addDiagnose(app);
  gap::addCheck(app);
  gap::addReport(app);
  gap::addApply(app);
  gap::addNext(app);
  gap::addBlind(app);
  gap::addReveal(app);
  gap::addImport(app);
  gap::addEffects(app);
  gap::addSettings(app);
  app.add_option_function<std::string>(
         "--config", useConfigFolder,
         "Folder of the configuration [config/ here, else the one next to this program's bin/]")
      ->trigger_on_parse();
  for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; })) {
    command->fallthrough();
    for (CLI::App* part : command->get_subcommands([](CLI::App*) { return true; })) part->fallthrough();
  }
  app.footer(
      "Examples:\n  bin/gap record --battery hang --secret 10 -o runs\n"
      "  bin/gap diagnose runs --json answer.json\n  bin/gap report answer.json\n"
      "Each has its own help: bin/gap diagnose --help");
  StopSignal stop;
  stop.catchSignals();
  if (const auto status = readCommandLine(app, argc, argv)) return *status;
  return 0;
}

}  // namespace

int main(int argc, char** argv) { return plumbline::guardedMain("gap", run, argc, argv); }
