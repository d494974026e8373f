// bin/gap diagnose: from runs to an answer.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <utility>

#include "framework/Parallel.h"
#include "framework/WriteFile.h"
#include "gap/answer/Answer.h"
#include "gap/diagnosis/DiagnosisAttempts.h"
#include "gap/diagnosis/HoldHint.h"
#include "gap/diagnosis/UnusedColumns.h"
#include "gap/replay/Segments.h"
#include "gap/replay/TrialOf.h"
#include "gap/report/MotionQuestion.h"
#include "gap/run/RunCheck.h"
#include "gap/run/RunFile.h"
#include "main/gap/ChangesOption.h"
#include "main/gap/Commands.h"
#include "main/gap/DiagnoseSets.h"
#include "main/gap/ProgressLine.h"
#include "main/gap/RobotOption.h"
#include "main/gap/Timing.h"
#include "robot/MechanismFile.h"

namespace plumbline::gap {

namespace {

struct DiagnoseOptions {
  std::vector<std::string> runs;
  std::string robot, json, timing, method;
  int jobs = 0, maxCauses = 0;
  double seconds = 240;
  ChangesOption changes;
  bool quiet = false;
};

/// Replaces long recordings by segments, also in the notes for the answer; returns the number of segments.
std::size_t cutLongRuns(std::vector<Trial>& trials, std::vector<RunNotes>& notes, double seconds) {
  std::vector<std::vector<Trial>> segments = segmentsOf(std::move(trials), seconds);
  std::vector<RunNotes> cut;
  std::size_t count = 0;
  trials.clear();
  for (std::size_t i = 0; i < segments.size(); ++i)
    for (Trial& segment : segments[i]) {
      RunNotes& of = cut.emplace_back(notes[i]);
      if (segment.motion != of.motion) {
        of.motion = segment.motion;
        of.duration = segment.time.back() - segment.time.front();
        ++count;
      }
      trials.push_back(std::move(segment));
    }
  notes = std::move(cut);
  return count;
}

/// Makes the folder of a file.
void makeFolderOf(const std::string& file) {
  const std::filesystem::path folder = std::filesystem::path(file).parent_path();
  std::error_code error;
  if (!folder.empty()) std::filesystem::create_directories(folder, error);
  if (error) throw std::runtime_error(folder.string() + " cannot be made: " + error.message());
}

void diagnoseRuns(const DiagnoseOptions& options) {
  const Timing timing;
  std::vector<std::string> folders;
  for (const std::string& path : options.runs)
    for (std::string& folder : findRuns(path)) folders.push_back(std::move(folder));
  std::vector<RunWarning> ignored;
  const std::string name = readRun(folders.front(), ignored).robot;
  const Mechanism robot = robotOf(options.robot, name);

  AnswerInput input;
  input.robot = robot.name;
  std::vector<Trial> trials;
  std::string refused;
  const RunChanges changes = options.changes.changes();
  for (const std::string& folder : folders) {
    RunNotes notes;
    notes.folder = folder;
    try {
      const Run run = readCheckedRun(folder, robot, notes.warnings, changes);
      if (run.robot != name) {
        throw RunError(folder + ": recorded on the robot '" + run.robot + "', the others on '" + name +
                       "'; diagnose one robot at a time");
      }
      notes.motion = run.motion;
      notes.freeBase = run.freeBase;
      notes.duration = run.duration();
      trials.push_back(trialOf(run, robot));
      notes.restarts = trials.back().restarts.size();
    } catch (const RunError& error) {
      // One bad run must not cost the good ones; none good is an error.
      std::fprintf(stderr, "gap: %s; this run is left out\n", error.what());
      refused = error.what();
      continue;
    }
    for (const RunWarning& warning : notes.warnings)
      std::fprintf(stderr, "gap: %s\n", warning.line(folder).c_str());
    input.runs.push_back(std::move(notes));
  }
  if (trials.empty()) throw RunError(refused);
  const std::size_t segments = options.seconds > 0 ? cutLongRuns(trials, input.runs, options.seconds) : 0;
  if (segments > 0 && !options.quiet)
    std::fprintf(stderr, "gap: looks at %zu segments of these long runs (--seconds)\n", segments);

  input.settings = servoSettings(trials);
  if (const std::string hint = holdHint(trials); !hint.empty())
    std::fprintf(stderr, "gap: %s\n", hint.c_str());

  const bool toFile = !options.json.empty() && options.json != "-";
  if (toFile) makeFolderOf(options.json);
  const std::string memory = toFile ? options.json + ".searches" : "";
  const int jobs = threadsFor(options.jobs);
  // Robots on their feet are still diagnosed by blocks: of 16 cases they were right in more (decision 21).
  const bool onFeet = std::ranges::any_of(trials, &Trial::freeBase);
  if (options.method.empty() ? !onFeet : options.method == "sets") {
    const SetsRequest request{robot, options.json,      options.timing, memory,
                              jobs,  options.maxCauses, options.quiet};
    diagnoseBySets(request, std::move(trials), std::move(input), timing);
    return;
  }
  input.remarks = unusedByBlocks(trials);
  DiagnosisOptions settings;
  settings.jobs = jobs;
  if (options.maxCauses > 0) settings.maxCauses = static_cast<std::size_t>(options.maxCauses);
  std::optional<ProgressLine> line(std::in_place, options.quiet);
  settings.progress = [&line](const std::string& stage, double share) { line->update(stage, share); };
  const auto say = [&line](const std::string& text) { line->say(text); };
  DiagnosisAttempts attempts(robot, settings, memory,
                             {options.quiet ? DiagnosisAttempts::Message() : say, say});
  const Diagnosis diagnosis = attempts.run(std::move(trials));
  line.reset();
  Evaluator& fine = attempts.evaluator();
  input.nextMotion = separatingMotion(robot, diagnosis);
  if (input.nextMotion.empty()) input.nextMotion = suggestion(diagnosis, fine.evidence());
  const std::string text = answerJson(input, diagnosis, fine) + "\n";
  timing.write(options.timing);
  if (options.json == "-") {
    std::fputs(text.c_str(), stdout);
    return;
  }
  if (toFile) writeFile(options.json, text);
  attempts.forget();
  std::printf("%s\n", verdictSentence(diagnosis).c_str());
  for (const Finding& finding : diagnosis.findings) {
    std::printf("  %-48s %5.1f %%  [%.3g, %.3g]  closes %.0f %% alone\n", describe(finding.cause).c_str(),
                100 * finding.probability, finding.lower, finding.upper, 100 * finding.closedAlone);
    if (const std::string inactiveIn = describeInactiveIn(finding.cause); !inactiveIn.empty())
      std::printf("    %s\n", inactiveIn.c_str());
    for (const Rival& rival : finding.rivals)
      std::printf("    or %-45s %5.1f %%\n", describe(rival.cause).c_str(), 100 * rival.probability);
  }
  std::printf("Gap on data left out of the fit, in units of noise: %.2f before, %.2f after, floor %.2f.\n",
              diagnosis.gap.before, diagnosis.gap.after, diagnosis.gap.floor);
  for (const std::string& line : input.remarks) std::printf("%s\n", line.c_str());
  std::printf("Next: %s\n", input.nextMotion.c_str());
}

}  // namespace

void addDiagnose(CommandLine& app) {
  auto options = std::make_shared<DiagnoseOptions>();
  CommandLine command = app.command("diagnose", "Finds where runs differ from the nominal model, and why");
  command.option("run", options->runs, "Run folders, or folders of run folders").required();
  command.option("--robot", options->robot,
                 "URDF with its servo table, or JSON file, or a name in config/robots "
                 "[the robot that the runs name]");
  command.option("--json", options->json, "Write the answer here; - for standard output");
  command.option("--jobs", options->jobs, "Threads [as many as cores]").range(1, 256);
  command
      .option("--max-causes", options->maxCauses,
              "Most causes in one answer [sets: 8, or 12 of a robot with many kinds of causes; blocks: 3]")
      .range(1, 12);
  command
      .option("--method", options->method,
              "sets: sets of causes, judged on recordings left out; blocks: causes one at a time, judged on "
              "half-seconds left out [sets; blocks for a robot on its feet]")
      .oneOf({"blocks", "sets"});
  command
      .option("--seconds", options->seconds,
              "Of longer runs with a fixed base, use segments of this total length [s]; 0: everything")
      .range(0., 1e5)
      .showDefault();
  options->changes.addTo(command);
  addTiming(command, options->timing);
  command.flag("--quiet", options->quiet, "No progress");
  command.footer(
      "Examples:\n  bin/gap diagnose runs --json answer.json\n"
      "  bin/gap diagnose sweep1 sweep2 --robot my_arm.urdf --jobs 4");
  command.whenChosen([options] { diagnoseRuns(*options); });
}

}  // namespace plumbline::gap
