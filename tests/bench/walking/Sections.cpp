#include "bench/walking/Sections.h"

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "framework/Parallel.h"
#include "gap/blind/BlindCase.h"
#include "training/WalkTraining.h"

namespace plumbline::bench {

namespace {

/// Digest of this program's file, with which all that it measures may change.
const std::string& thisProgram() {
  static const std::string digest = [] {
    std::ifstream file("/proc/self/exe", std::ios::binary);
    return gap::sha256({std::istreambuf_iterator<char>(file), {}});
  }();
  return digest;
}

std::string fileOf(const BenchSetup& setup, const LongPart& part) {
  const std::string walk = training::walkFile(part.robot.gaits, {}, "");
  const std::string key = fmt::format("{} {} {} {} {} {} {}", thisProgram(), setup.seeds, setup.minutes,
                                      setup.tries, part.robot.name, part.what, walk);
  return setup.parts + "/" + gap::sha256(key).substr(0, 20) + ".json";
}

}  // namespace

void measureEach(std::size_t count, const BenchSetup& setup, Report& report, Page& page,
                 const std::function<void(std::size_t, Report&, Page&)>& measure) {
  std::vector<Report> reports(count);
  std::vector<Page> pages(count);
  parallel(count, threadsFor(setup.jobs), [&](std::size_t i) { measure(i, reports[i], pages[i]); });
  for (std::size_t i = 0; i < count; ++i) {
    report.append(reports[i]);
    page.figures.insert(page.figures.end(), pages[i].figures.begin(), pages[i].figures.end());
  }
}

void measureEach(std::size_t count, const BenchSetup& setup, Report& report,
                 const std::function<void(std::size_t, Report&)>& measure) {
  Page none;
  measureEach(count, setup, report, none, [&](std::size_t i, Report& part, Page&) { measure(i, part); });
}

void measureLong(std::size_t count, const BenchSetup& setup, Report& report,
                 const std::function<LongPart(std::size_t)>& part,
                 const std::function<void(std::size_t, Report&)>& measure) {
  std::filesystem::create_directories(setup.parts);
  measureEach(count, setup, report, [&](std::size_t i, Report& own) {
    const std::string file = fileOf(setup, part(i));
    if (const std::optional<Report> kept = Report::kept(file)) {
      own = *kept;
      return;
    }
    measure(i, own);
    own.keep(file);
  });
}

}  // namespace plumbline::bench
