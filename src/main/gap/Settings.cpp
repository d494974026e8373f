// bin/gap settings: which settings of the embedded simulator differ from the league's server.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "framework/ConfigFolder.h"
#include "framework/Parallel.h"
#include "framework/WriteFile.h"
#include "gap/settings/SettingsAnswer.h"
#include "main/gap/Commands.h"
#include "main/gap/ProgressLine.h"
#include "main/gap/Timing.h"
#include "simulation/physics/Physics.h"

namespace plumbline::gap {

namespace {

struct Options {
  /// The recordings that come with the project are next to its configuration.
  std::string traces = (std::filesystem::path(configFolder()) / "../tests/data/traces").lexically_normal();
  std::string engine = "ode", json, timing;
  std::vector<std::string> without;
  int jobs = 0;
  bool quiet = false;
};

void diagnose(const Options& options) {
  const Timing timing;
  SimulatorSetup nominal;
  nominal.world.engine = options.engine;
  for (const std::string& omission : options.without) nominal = without(nominal, omission);
  const TraceEvidence evidence(readTraces(options.traces));
  SettingsOptions settings;
  settings.jobs = threadsFor(options.jobs);
  SettingsDiagnosis diagnosis;
  {
    ProgressLine line(options.quiet);
    settings.progress = [&](const std::string& stage, double share) { line.update(stage, share); };
    diagnosis = diagnoseSettings(evidence, nominal, settings);
  }
  timing.write(options.timing);
  const std::string text = settingsJson(diagnosis, "simspark") + "\n";
  if (options.json == "-") {
    std::fputs(text.c_str(), stdout);
    return;
  }
  if (!options.json.empty()) writeFile(options.json, text);
  std::printf("%s\n", settingsSentence(diagnosis).c_str());
  for (const SettingFinding& f : diagnosis.findings) {
    const Setting& s = *f.value.setting;
    std::printf("  %-34s %5.1f %%  [%.3g, %.3g], was %s; closes %.0f %% alone\n", describe(f.value).c_str(),
                100 * f.probability, f.lower, f.upper, valueText(s, f.nominal).c_str(), 100 * f.closedAlone);
    for (const SettingRival& rival : f.rivals)
      std::printf("    or %-31s %5.1f %%\n", describe(rival.value).c_str(), 100 * rival.probability);
  }
  for (std::size_t i = 0; i < std::min<std::size_t>(5, diagnosis.cells.size()); ++i) {
    const SettingCell& cell = diagnosis.cells[i];
    if (cell.share < 0.005) break;
    std::printf("  where: %-15s in %-14s %3.0f %% of the gap, %.2g %s, %.2g after, floor %.2g\n",
                cell.signal.c_str(), cell.motion.c_str(), 100 * cell.share, cell.gap, cell.unit.c_str(),
                cell.after, cell.floor);
  }
  std::printf(
      "Gap on %zu windows left out of the fit, in units of the nominal's own: %.2f before, %.2f after, floor "
      "%.2f.\n",
      diagnosis.leftOutWindows, diagnosis.gap.before, diagnosis.gap.after, diagnosis.gap.floor);
  std::printf("Next: %s\n", diagnosis.nextMotion.c_str());
}

}  // namespace

void addSettings(CommandLine& app) {
  auto options = std::make_shared<Options>();
  CommandLine command = app.command(
      "settings", "Finds settings of the embedded simulator that differ from the league's server");
  command
      .option("--traces", options->traces,
              "Folder of recordings of the league's server, *_t0.csv.gz to *_t4.csv.gz")
      .showDefault();
  std::string names;
  for (const std::string& name : omissions()) names += (names.empty() ? "" : ", ") + name;
  command.option("--without", options->without,
                 "Leave this out of the simulator first, to see whether it is found: " + names);
  command.option("--engine", options->engine, "Physics of the simulator")
      .oneOf(simulation::physicsEngines())
      .showDefault();
  command.option("--json", options->json, "Write the answer here; - for standard output");
  addTiming(command, options->timing);
  command.option("--jobs", options->jobs, "Threads [as many as cores]").range(1, 256);
  command.flag("--quiet", options->quiet, "No progress");
  command.footer(
      "Examples:\n  bin/gap settings --without drag\n"
      "  bin/gap settings --engine bullet --json answer.json\n"
      "  bin/gap settings --traces my_recordings --without action_delay --without drag");
  command.whenChosen([options] { diagnose(*options); });
}

}  // namespace plumbline::gap
