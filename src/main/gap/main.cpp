// bin/gap: the sim-to-real diagnosis. Each subcommand stands in a file of its own.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>
#include <memory>

#include "framework/StopSignal.h"
#include "main/gap/Commands.h"

namespace {

plumbline::StopSignal* stopSignal = nullptr;

}  // namespace

bool plumbline::gap::stopRequested() { return stopSignal && stopSignal->requested(); }

int main(int argc, char** argv) {
  using namespace plumbline;
  constexpr int badInput = 2;
  CLI::App app(
      "Finds what a simulator lacks: where it differs from a real robot, which unmodelled effect is the "
      "cause, "
      "and how far the gap shrinks once that effect is in.",
      "gap");
  app.set_help_flag("-h,--help", "Print this help");
  app.require_subcommand(1);
  gap::addRecord(app);
  gap::addDiagnose(app);
  gap::addReport(app);
  gap::addApply(app);
  gap::addNext(app);
  gap::addBlind(app);
  gap::addReveal(app);
  gap::addImport(app);
  gap::addEffects(app);
  gap::addSettings(app);
  app.footer(
      "Examples:\n  bin/gap record --battery hang --secret 7 -o runs\n"
      "  bin/gap diagnose runs --json answer.json\n  bin/gap report answer.json\n"
      "Each has its own help: bin/gap diagnose --help");
  try {
    StopSignal stop;
    stop.catchSignals();
    stopSignal = &stop;
    app.parse(argc, argv);
    return stop.requested() ? 130 : 0;
  } catch (const CLI::Success& success) {
    return app.exit(success);
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "gap: %s; see gap --help\n", error.what());
    return badInput;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "gap: %s\n", error.what());
    return badInput;
  }
}
