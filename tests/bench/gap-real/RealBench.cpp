// Real robots: a diagnosis of some recordings, tested on others. Writes build/bench/gap-real.json and .md.
// The recordings are not part of the project. Environment:
//   DATA   their folder [../shared/gap/real]
//   JOBS   threads [as many as cores]
//   ROBOT  xl330 or so101 alone
//   SPLIT  one split alone: kp100, kp200, kp800 of xl330; a, b, c of so101
//   METHOD sets or blocks [sets]
// A split that is in build/bench/gap-real-splits is taken as it is, so a run that was stopped goes on, and
// the page holds every split that was run. After a change of the diagnosis remove that folder.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "KeptSplit.h"
#include "Splits.h"
#include "framework/WriteFile.h"

namespace plumbline::bench {
namespace {

using nlohmann::json;

constexpr const char* splitsFolder = "build/bench/gap-real-splits";
constexpr const char* head =
    "Recordings of real robots, made by others; no effect was planted in them. Each diagnosis sees the "
    "recordings for fitting alone; then the commands of the others are played on the nominal robot and on "
    "the robot with what was found (`bin/gap apply`), free from beginning to end. Closed: (before - after) / "
    "(before - floor). Nothing is random but the search, whose seed is fixed. A verdict of unknown says that "
    "more remains than noise: these robots have more to them than the causes named.\n";

/// One line per split: both methods, as far as they were run.
std::string summaryOf(const RealRobot& robot) {
  std::string rows;
  for (const RealSplit& split : robot.splits)
    for (const Method method : {Method::sets, Method::blocks}) {
      const KeptSplit kept(splitsFolder, robot.id, split.name, method);
      if (!kept.done()) continue;
      const json one = kept.read();
      const auto percent = [&one](const char* key) {
        if (one[key].is_null()) return std::string();
        char buffer[32];
        std::snprintf(buffer, sizeof buffer, "%.0f %%", 100 * one[key].get<double>());
        return std::string(buffer);
      };
      rows += "| " + robot.id + " " + split.name + " | " + nameOf(method) + " | " + percent("closed") +
              " | " + percent("mean") + " | " + percent("claimed") + " | " +
              std::to_string(std::lround(one["seconds"].get<double>())) + " | " +
              one["date"].get<std::string>() + " |\n";
    }
  return rows;
}

struct Wanted {
  std::string folder, robot, split;
  Method method = Method::sets;
  int jobs = 1;
};

Wanted wantedOf() {
  const auto given = [](const char* name, const char* otherwise) {
    const char* value = std::getenv(name);
    return std::string(value && *value ? value : otherwise);
  };
  Wanted w{given("DATA", "../shared/gap/real"), given("ROBOT", ""), given("SPLIT", "")};
  const std::string method = given("METHOD", "sets");
  if (method != "sets" && method != "blocks")
    throw std::runtime_error("METHOD=" + method + " is neither sets nor blocks");
  if (method == "blocks") w.method = Method::blocks;
  const std::string jobs = given("JOBS", "");
  if (jobs.find_first_not_of("0123456789") != std::string::npos || jobs.size() > 3)
    throw std::runtime_error("JOBS=" + jobs + " is no number of threads");
  w.jobs = jobs.empty() ? static_cast<int>(std::max(1U, std::thread::hardware_concurrency()))
                        : std::max(1, std::stoi(jobs));
  return w;
}

bool takes(const Wanted& wanted, const RealRobot& robot, const RealSplit& split) {
  return (wanted.robot.empty() || wanted.robot == robot.id) &&
         (wanted.split.empty() || wanted.split == split.name);
}

void check(const Wanted& wanted, const std::vector<RealRobot>& robots) {
  std::size_t count = 0;
  for (const RealRobot& robot : robots)
    for (const RealSplit& split : robot.splits) {
      if (!takes(wanted, robot, split)) continue;
      ++count;
      std::error_code error;
      if (!std::filesystem::is_directory(wanted.folder + "/" + robot.folder, error))
        throw std::runtime_error(wanted.folder + " has no " + robot.folder +
                                 ": recordings of real robots are not part of the project; name their "
                                 "folder, make bench-gap-real DATA=FOLDER");
    }
  if (!count)
    throw std::runtime_error("ROBOT=" + wanted.robot + " SPLIT=" + wanted.split +
                             " names nothing; xl330 has kp100, kp200, kp800, so101 has a, b, c");
}

void writePage(const std::vector<RealRobot>& robots) {
  std::string page = head, rows;
  for (const RealRobot& robot : robots) rows += summaryOf(robot);
  page +=
      "\n| recordings | method | closed | mean of the tests, no floor | claimed | CPU s | measured on "
      "|\n|---|---|---|---|---|---|---|\n" +
      rows;
  json figures = json::array();
  for (const RealRobot& robot : robots) {
    std::string pages;
    for (const RealSplit& split : robot.splits)
      for (const Method method : {Method::sets, Method::blocks}) {
        const KeptSplit kept(splitsFolder, robot.id, split.name, method);
        if (!kept.done()) continue;
        const json one = kept.read();
        pages += one["page"].get<std::string>();
        figures.insert(figures.end(), one["figures"].begin(), one["figures"].end());
        if (!one["claimed"].is_null() && !one["mean"].is_null())
          figures.push_back(
              {{"name", "gap-real.claim-off." + robot.id + "." + split.name + "." + nameOf(method)},
               {"value", 100 * std::abs(one["claimed"].get<double>() - one["mean"].get<double>())},
               {"unit", "points"},
               {"better", "lower"},
               {"target", 10}});
      }
    if (!pages.empty()) page += "\n## " + robot.title + "\n\n" + robot.about + pages + "\n" + robot.limits;
  }
  writeFile("build/bench/gap-real.md", page);
  writeFile("build/bench/gap-real.json", figures.dump(1) + "\n");
}

void run(const Wanted& wanted) {
  const std::vector<RealRobot> robots = realRobots();
  check(wanted, robots);
  std::filesystem::create_directories(splitsFolder);
  for (const RealRobot& robot : robots)
    for (const RealSplit& split : robot.splits) {
      const KeptSplit kept(splitsFolder, robot.id, split.name, wanted.method);
      if (!takes(wanted, robot, split) || kept.done()) continue;
      std::printf("%s %s: %s\n", robot.id.c_str(), split.name.c_str(), split.what.c_str());
      std::fflush(stdout);
      kept.write(split, runSplit(split, robot.model, wanted.folder + "/" + robot.folder, robot.maxCauses,
                                 wanted.jobs, wanted.method));
      writePage(robots);
    }
  writePage(robots);
}

}  // namespace
}  // namespace plumbline::bench

int main(int argc, char** argv) try {
  if (argc > 1)
    throw std::runtime_error(std::string(argv[1]) +
                             " is not known: DATA, JOBS, ROBOT, SPLIT and METHOD of the environment are");
  plumbline::bench::run(plumbline::bench::wantedOf());
} catch (const std::exception& problem) {
  std::fprintf(stderr, "bench gap-real: %s\n", problem.what());
  return 2;
}
