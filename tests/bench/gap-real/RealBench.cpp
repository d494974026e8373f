// Real robots: a diagnosis of some recordings, tested on others. The recordings are not part of the project:
// DATA names their folder (../shared/gap/real), JOBS the threads, ROBOT one of them.
// Writes build/bench/gap-real.json and .md.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "RealRuns.h"

namespace plumbline::bench {
namespace {

using nlohmann::json;

std::string text(const char* format, double a) {
  char buffer[64];
  std::snprintf(buffer, sizeof buffer, format, a);
  return buffer;
}

std::vector<RealSplit> pendulumSplits() {
  std::vector<RealSplit> splits;
  const std::vector<std::string> gains = {"kp100", "kp200", "kp800"};
  for (const std::string& tested : gains) {
    RealSplit split{tested, "fit at the other two gains, tested at " + tested, {}, {}, {}, 1e9};
    for (const std::string& gain : gains)
      for (const char* motion : {"lift_and_drop", "sin_sin", "sin_time_square", "up_and_down"})
        (gain == tested ? split.test : split.fit).push_back(gain + "_" + motion);
    splits.push_back(std::move(split));
  }
  return splits;
}

std::vector<RealSplit> armSplits() {
  const std::vector<std::vector<std::string>> halves = {
      {"chirp_sweep", "friction_gravity", "step_response", "velocity_ramp"},
      {"actuator_bandwidth", "coupled_joints", "multisine", "trapezoidal_profile"}};
  const std::vector<std::string> all = {
      "actuator_bandwidth", "backlash_detection", "chirp_sweep",         "coupled_joints", "custom_motion",
      "end_effector",       "frequency_sweep",    "friction_gravity",    "multisine",      "prbs_excitation",
      "static_holding",     "step_response",      "trapezoidal_profile", "velocity_ramp"};
  std::vector<RealSplit> splits;
  for (std::size_t i = 0; i < halves.size(); ++i) {
    RealSplit split{i == 0 ? "a" : "b", "fit on four windows of 5 s of each of", halves[i], {}, {}, 20};
    for (const std::string& motion : halves[i]) split.what += " " + motion;
    for (const std::string& motion : all) {
      if (std::ranges::find(halves[i], motion) != halves[i].end()) continue;
      split.test.push_back(motion);
      // These two were recorded under other servo settings the second time.
      if (motion != "prbs_excitation" && motion != "static_holding")
        split.repeats[motion] = motion + "_session1";
    }
    splits.push_back(std::move(split));
  }
  return splits;
}

void tell(std::ofstream& page, json& figures, const std::string& robot, const RealSplit& split,
          const RealResult& r) {
  const std::string name = robot + "." + split.name;
  page << "\n### " << split.name << ": " << split.what << "\n\nVerdict " << nameOf(r.diagnosis.verdict)
       << "; position, root mean square over the tests: " << text("%.1f", 1000 * r.before) << " mrad before, "
       << text("%.1f", 1000 * r.after) << " after, floor "
       << (r.floor > 0 ? text("%.1f", 1000 * r.floor) : "none known (no repeats)") << ": **"
       << text("%.0f %%", 100 * r.closed()) << " closed**. The diagnosis took " << text("%.0f", r.seconds)
       << " s.\n\n| cause | value | interval | probability | closes alone | closes last | or |\n"
          "|---|---|---|---|---|---|---|\n";
  for (const gap::Finding& f : r.diagnosis.findings) {
    std::string rivals;
    for (const gap::Rival& rival : f.rivals)
      rivals += (rivals.empty() ? "" : ", ") + describe(rival.cause) + text(" (%.2f)", rival.probability);
    page << "| " << f.cause.effect->id << " at " << f.cause.place.at << " | " << text("%.3g", f.cause.value)
         << " " << f.cause.effect->unit << " | " << text("%.3g", f.lower) << " to " << text("%.3g", f.upper)
         << " | " << text("%.2f", f.probability) << " | " << text("%.0f %%", 100 * f.closedAlone) << " | "
         << text("%.0f %%", 100 * f.closedLast) << " | " << rivals << " |\n";
  }
  page << "\n| test | before, mrad | after, mrad | floor, mrad | closed |\n|---|---|---|---|---|\n";
  for (const TestError& e : r.tests)
    page << "| " << e.run << " | " << text("%.1f", 1000 * e.before) << " | " << text("%.1f", 1000 * e.after)
         << " | " << (e.repeated ? text("%.1f", 1000 * e.floor) : "") << " | "
         << text("%.0f %%", 100 * (e.before - e.after) / (e.before - e.floor)) << " |\n";
  page << std::flush;
  figures.push_back({{"name", "gap-real.closed." + name},
                     {"value", r.closed()},
                     {"unit", "1"},
                     {"better", "higher"},
                     {"target", 0.7}});
  figures.push_back(
      {{"name", "gap-real.time." + name}, {"value", r.seconds}, {"unit", "s"}, {"better", "lower"}});
  std::printf("%s: %.1f -> %.1f mrad, floor %.1f, closed %.0f %%, %s, %.0f s\n", name.c_str(),
              1000 * r.before, 1000 * r.after, 1000 * r.floor, 100 * r.closed(), nameOf(r.diagnosis.verdict),
              r.seconds);
  for (const gap::Finding& f : r.diagnosis.findings)
    std::printf("  %s %.2f\n", describe(f.cause).c_str(), f.probability);
  std::fflush(stdout);
}

constexpr const char* pendulumText =
    "\n## XL330 servo with a pendulum\n\nTwelve recordings of 6 s: four motions at three firmware gains. All "
    "motions at one gain test what was found at the other two, in turn. There is no repeat, so nothing is "
    "taken off as not closable.\n";
constexpr const char* pendulumLimits =
    "\nWhat these recordings cannot tell: the electrical side is known (the duty was recorded and follows "
    "the "
    "control law), so what is missing lies behind it, in motor, gear or load; but published constants of "
    "this "
    "motor differ by 40 % in its resistance and 6 % in its torque per ampere, and a wrong constant looks "
    "like "
    "friction that depends on speed (back-EMF) or like a gain. The mass of the arm and the zero of the angle "
    "are not known either: an offset, a bias of torque and a centre of mass aside are one thing on one "
    "joint. "
    "One unit, one load, 27 to 40 degrees: friction that depends on temperature is not apart from "
    "friction.\n";
constexpr const char* armText =
    "\n## SO-101 arm\n\nFourteen motions of 120 s, each recorded twice. Windows of four in session 2 are "
    "fitted, "
    "all of session 2 of the others is the test. The floor is one session's part of the difference between "
    "the two "
    "(over the square root of two), which holds a new calibration of two joints, too. Tests whose repeat ran "
    "under other servo settings (prbs_excitation, static_holding) are shown and do not count.\n";
constexpr const char* armLimits =
    "\nWhat these recordings cannot tell: a servo gain lower than the published one and links heavier than "
    "their model look alike, as all motions stay within 0.15 rad of one pose: another load or pose is "
    "needed. "
    "Zeros of the angles (by hand, 0.2 rad), whether the base stands level and what is mounted on the "
    "gripper "
    "are in the gravity torque, which a bias of torque absorbs. The order of bus transactions leaves 40 % of "
    "5 to 17 ms open, which is a command_delay of some milliseconds. Signs of Rotation, Wrist_Roll and Jaw "
    "are the recorder's.\n";

int run(const std::string& folder, const std::string& only, int jobs) {
  namespace fs = std::filesystem;
  std::error_code error;
  if (!fs::is_directory(folder + "/xl330_pendulum", error) || !fs::is_directory(folder + "/so101", error)) {
    std::fprintf(
        stderr,
        "bench gap-real: %s has no xl330_pendulum and so101: recordings of real robots are not part of "
        "the project; name their folder, make bench-gap-real DATA=FOLDER\n",
        folder.c_str());
    return 2;
  }
  if (!only.empty() && only != "xl330" && only != "so101") {
    std::fprintf(stderr, "bench gap-real: ROBOT=%s is not known; xl330, so101, or none for both\n",
                 only.c_str());
    return 2;
  }
  fs::create_directories("build/bench");
  std::ofstream page("build/bench/gap-real.md");
  page
      << "Recordings of real robots, made by others; no effect was planted in them. Each diagnosis sees the "
         "recordings for fitting alone; then the commands of the others are played on the nominal robot and "
         "on the robot with what was found (`bin/gap apply`), free from beginning to end. Closed: (before - "
         "after) / (before - floor). Nothing is random but the search, whose seed is fixed. A verdict of "
         "unknown says that more remains than noise: these robots have more to them than the causes named.\n";
  json figures = json::array();
  if (only.empty() || only == "xl330") {
    page << pendulumText;
    for (const RealSplit& split : pendulumSplits())
      tell(page, figures, "xl330", split,
           runSplit(split, "xl330_pendulum", folder + "/xl330_pendulum", 5, jobs));
    page << pendulumLimits;
  }
  if (only.empty() || only == "so101") {
    page << armText;
    for (const RealSplit& split : armSplits())
      tell(page, figures, "so101", split, runSplit(split, "so101", folder + "/so101", 6, jobs));
    page << armLimits;
  }
  std::ofstream("build/bench/gap-real.json") << figures.dump(1) << '\n';
  return 0;
}

}  // namespace
}  // namespace plumbline::bench

int main(int argc, char** argv) {
  if (argc > 1) {
    std::fprintf(stderr, "bench gap-real: %s is not known: DATA, JOBS and ROBOT of the environment are\n",
                 argv[1]);
    return 2;
  }
  try {
    const char *data = std::getenv("DATA"), *jobs = std::getenv("JOBS"), *robot = std::getenv("ROBOT");
    return plumbline::bench::run(data ? data : "../shared/gap/real", robot ? robot : "",
                                 jobs ? std::max(1, std::atoi(jobs))
                                      : static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
  } catch (const std::exception& problem) {
    std::fprintf(stderr, "bench gap-real: %s\n", problem.what());
    return 2;
  }
}
