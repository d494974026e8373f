// bin/gap: the sim-to-real diagnosis. Each subcommand has a file of its own.
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
  CommandLine app(
      "Finds what a simulator lacks: where it differs from a real robot, which unmodelled effect is the "
      "cause, "
      "and how far the gap shrinks once that effect is in.",
      "gap");
  app.requireCommand();
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
  app.action("--config", useConfigFolder,
             "Folder of the configuration [config/ here, else the one next to this program's bin/]")
      .atOnce();
  app.shareOptions();
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
