// The walk measured: speeds and falls of all robots, the tables and figures of the thesis, pushes, the
// velocity estimate and the cost. Prints tables; writes build/bench/walking.json, walking.md and
// walking.html.
//
//   bench/walking [SEEDS [MINUTES [TRIES]]] [--robots A,B,..] [--sections A,B,..] [--jobs N] [--name NAME]
//
// What takes long is kept in build/bench/walking-parts: a benchmark that was stopped goes on with it.
//
// SEEDS (10): of each measurement; MINUTES (10): of random requests per robot and seed; TRIES (100): of a
// push. Robots: type0 .. type4, type0_plain, type3_plain, nao-bullet, nao-mujoco, and type0@server or
// type0@HOST:AGENTPORT:MONITORPORT on a SimSpark server that is in step with its agents. Sections: speeds,
// thesis, pushes, estimate. Jobs: threads, as many as cores without it; the cost of a cycle is measured on
// one. Name: of the files written, walking without it.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <stdexcept>

#include "bench/walking/Sections.h"
#include "framework/WriteFile.h"

namespace {

using namespace plumbline::bench;

std::vector<std::string> split(const std::string& list) {
  std::vector<std::string> parts;
  for (std::size_t begin = 0; begin <= list.size();) {
    const std::size_t end = std::min(list.find(',', begin), list.size());
    parts.push_back(list.substr(begin, end - begin));
    begin = end + 1;
  }
  return parts;
}

struct Arguments {
  BenchSetup setup;
  std::vector<std::string> sections{"speeds", "thesis", "pushes", "estimate"};
  std::string name = "walking";

  bool has(const char* section) const { return std::ranges::find(sections, section) != sections.end(); }
};

double numberOf(const std::string& text, double least) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= least))
    throw std::invalid_argument(fmt::format("'{}' is no number of at least {}", text, least));
  return value;
}

Arguments read(int argc, char** argv) {
  Arguments arguments;
  int position = 0;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    if (word.starts_with("--")) {
      if (i + 1 == argc) throw std::invalid_argument(word + " needs a value after it");
      if (word == "--jobs") {
        arguments.setup.jobs = static_cast<int>(numberOf(argv[++i], 1));
        continue;
      }
      if (word == "--name") {
        arguments.name = argv[++i];
        if (arguments.name.find_first_of("/.") != std::string::npos)
          throw std::invalid_argument("'" + arguments.name + "' is no name; letters and - will do");
        continue;
      }
      const std::vector<std::string> list = split(argv[++i]);
      if (word == "--robots") {
        for (const std::string& name : list) subjectOf(name);
        arguments.setup.robots = list;
      } else if (word == "--sections") {
        for (const std::string& name : list)
          if (!Arguments().has(name.c_str()))
            throw std::invalid_argument("no section '" + name +
                                        "'; there is speeds, thesis, pushes, estimate");
        arguments.sections = list;
      } else {
        throw std::invalid_argument("no option '" + word +
                                    "'; there is --robots, --sections, --jobs and --name");
      }
      continue;
    }
    BenchSetup& setup = arguments.setup;
    switch (position++) {
      case 0:
        setup.seeds = static_cast<int>(numberOf(word, 2));
        break;
      case 1:
        setup.minutes = numberOf(word, 0.1);
        break;
      case 2:
        setup.tries = static_cast<int>(numberOf(word, 20));
        break;
      default:
        throw std::invalid_argument("'" + word + "' is one number too many");
    }
  }
  return arguments;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const Arguments arguments = read(argc, argv);
    const BenchSetup& setup = arguments.setup;
    std::filesystem::create_directories("build/bench");
    Report report;
    report.paragraph(
        fmt::format("{} seeds, {:.3g} minutes of random requests per run, {} tries of every push. Why "
                    "targets are missed: "
                    "[the walk's reference](../reference/walk.md#where-it-misses-its-targets-and-why).",
                    setup.seeds, setup.minutes, setup.tries));
    const bool onServer =
        std::ranges::any_of(setup.robots, [](const std::string& name) { return subjectOf(name).onServer; });
    if (onServer)
      report.paragraph(
          "Robots \"@server\" were on a SimSpark server that waits for its agents, one at a time, in play "
          "on, "
          "and a trainer put them to their places. What is known of them is what the server's monitor port "
          "tells: poses within 5 mm and 0.3 degrees, up to two cycles old. Nobody can push or carry a robot "
          "there, so 60 s at full speed are laps of the field, each from a stand, whose first two seconds do "
          "not count.");
    Page page;
    page.title = "The walk, measured";
    page.introduction = fmt::format(
        "Figures of chapter 4 of the thesis (Seekircher 2015) drawn from this walk {}; written by make {}.",
        onServer ? "on a SimSpark server" : "in the embedded simulator",
        onServer ? "bench-walk-server" : "bench-walk");
    // After each section: what was measured is not lost when a later one fails.
    const auto write = [&] {
      const std::string files = "build/bench/" + arguments.name;
      plumbline::writeFile(files + ".json", report.json());
      plumbline::writeFile(files + ".md", report.tables());
      // Sections without figures leave the page of an earlier run as it is.
      if (!page.figures.empty()) plumbline::writeFile(files + ".html", page.html());
    };
    if (arguments.has("speeds")) measureSpeeds(setup, report), write();
    if (arguments.has("thesis")) measureThesisTables(setup, report, page), write();
    if (arguments.has("pushes")) measurePushes(setup, report), write();
    if (arguments.has("estimate")) measureEstimate(setup, report, page), write();
  } catch (const std::exception& error) {
    fmt::print(stderr, "walking benchmark: {}\n", error.what());
    return 2;
  }
  return 0;
}
