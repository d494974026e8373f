#include "Page.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <thread>

#include "support/Today.h"

namespace plumbline::bench {

using namespace gap;

namespace {

constexpr Target targets[] = {{"top1", .95, true},
                              {"top3", .99, true},
                              {"false_alarms", .02, false},
                              {"unknown_found", .85, true},
                              {"false_unknown", .05, false},
                              {"mixture_f1", .85, true},
                              {"parameter_error", .1, false},
                              {"gap_closed", .9, true},
                              {"ece", .05, false}};
constexpr std::size_t fullSet = 200;

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown processor";
}

std::string introduction(const BenchResult& r) {
  const auto& cases = r.set.cases;
  const auto many = [&](BlindKind kind) {
    return std::to_string(std::ranges::count(cases, kind, &BlindCase::kind)) + " ";
  };
  std::string text = "Written by `make bench-gap` on " + today() + " (" + processor() + ", " +
                     std::to_string(std::thread::hardware_concurrency()) + " cores). " +
                     std::to_string(cases.size()) + " cases, seed " + std::to_string(r.set.seed) + ": " +
                     many(BlindKind::none) + "without any effect, " + many(BlindKind::single) +
                     "with one of the library, " + many(BlindKind::hard) +
                     "with one that has a neighbour which looks alike, " + many(BlindKind::mixture) +
                     "with two, " + many(BlindKind::outside) + "with one that the library lacks. ";
  text += r.set.robot + " simulated in " +
          (r.set.engine == "mujoco" || r.set.engine == "program"
               ? "MuJoCo"
               : "the project's own replay at a quarter of its step") +
          ", " + (r.set.battery == "hang" ? "hung up, five runs" : "hung up and standing") +
          " per case. The diagnosis runs as a process of its own on a folder without the answer.\n";
  if (r.timing.count) {
    char line[200];
    std::snprintf(
        line, sizeof line,
        "\nCPU time per diagnosis: %.0f s on average, 95 %% within %.0f s, at most %.0f s (%zu timed); "
        "it spreads over the cores it is given.\n",
        r.timing.mean, r.timing.p95, r.timing.most, r.timing.count);
    text += line;
  }
  return text;
}

std::string figures(const BenchResult& r) {
  std::string text =
      "\nIntervals are 95 %: Wilson's for shares, bootstrap over the cases for the rest. Figures are for "
      "cases with a gap of 3 times the noise or more, and for cases without an effect.\n\n" +
      head({"", "value and interval", "cases", "target", "met"});
  for (const Figure& f : r.own.figures) {
    const Target* t = targetOf(f.id);
    const bool met = t && (t->higher ? f.value >= t->value : f.value <= t->value);
    text += row({f.what, cell(f), std::to_string(f.count),
                 t ? (t->higher ? ">= " : "<= ") + number(t->value) : "",
                 t && f.count ? (met ? "yes" : "no") : ""});
  }
  if (r.own.missing)
    text += "\n" + std::to_string(r.own.missing) + " cases have no answer; they count as wrong.\n";
  if (r.set.cases.size() < fullSet)
    text += "\n" + std::to_string(r.set.cases.size()) +
            " cases are few: the intervals say how little they prove. `CASES=200 make bench-gap` makes the "
            "full set.\n";
  return text;
}

std::string severity(const BenchResult& r) {
  std::string text =
      "\n## By severity\n\nEffect and place first, singles, by the gap over the noise in the channel that "
      "shows it best:\n\n" +
      head({"gap over noise", "share and interval", "cases"});
  for (const Figure& f : r.own.bySeverity) text += row({f.what, cell(f), std::to_string(f.count)});
  return text;
}

std::string comparisonSection(const BenchResult& r) {
  if (r.ways.size() < 2) return "";
  std::string text =
      "\n## Comparison with simpler methods\n\nOn the same " + std::to_string(r.ways.front().score.cases) +
      " cases; the oracle is asked only where the library has the effect. A method that gives only a place "
      "names no effect. The simpler methods have no verdict `unknown`; each has its own rule for `none`:\n\n"
      "- CMA-ES fit of everything: 450 evaluations of one value per effect at the joint with the largest "
      "gap, its link, the whole robot and the inertial sensor. It names the largest deviation relative to "
      "its bounds.\n"
      "- Nested friction models: none, Coulomb, + viscous, + Stribeck, + load at that joint; the smallest "
      "error on stretches that were not fitted decides, and the term whose removal costs most is named.\n"
      "- Best single effect by BIC: the same search as the diagnosis, without data left out.\n\n";
  constexpr const char* columns[] = {"top1",          "place",      "hard",           "false_alarms",
                                     "unknown_found", "mixture_f1", "parameter_error"};
  std::vector<std::string> titles = {""};
  for (const char* id : columns) titles.push_back(r.own.figure(id).what);
  text += head(titles);
  for (const Way& way : r.ways) {
    std::vector<std::string> cells = {way.what};
    for (const char* id : columns)
      cells.push_back(way.placeOnly && std::string(id) != "place" ? "-" : cell(way.score.figure(id)));
    text += row(cells);
  }
  return text;
}

constexpr const char* limits =
    "\n## Limits\n\n"
    "- The reality is simulated. Its servo, friction and gear are implemented separately from those of the "
    "diagnosis, in another engine with other time steps, but by the same project and with the same law.\n"
    "- Sizes are drawn from ranges and then adjusted so that the gap is between 3 and 100 times the noise "
    "(12 for pairs that look alike). If a place shows less, the case is kept with its ratio and counts only "
    "by severity. The ratio of a mixture is that of the weaker effect.\n"
    "- An axis is part of the place. A verdict of unknown names nothing, even if its nearest explanation is "
    "right.\n"
    "- The gap closed is each answer's own figure, for stretches of the runs that it did not fit.\n"
    "- If the robot hangs in all runs, effects of ground, feet and external forces are not drawn.\n";

}  // namespace

const Target* targetOf(const std::string& id) {
  for (const Target& t : targets)
    if (id == t.id) return &t;
  return nullptr;
}

Timing timingOf(std::vector<double> seconds) {
  Timing timing;
  timing.count = seconds.size();
  if (seconds.empty()) return timing;
  std::ranges::sort(seconds);
  for (const double s : seconds) timing.mean += s / static_cast<double>(seconds.size());
  const auto rank = static_cast<std::size_t>(std::ceil(0.95 * static_cast<double>(seconds.size())));
  timing.p95 = seconds[rank - 1];
  timing.most = seconds.back();
  return timing;
}

std::string number(double x) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3f", x);
  return text;
}

std::string cell(const Figure& f) {
  if (f.count == 0) return "-";
  return number(f.value) + " [" + number(f.lower) + ", " + number(f.upper) + "]";
}

std::string row(const std::vector<std::string>& cells) {
  std::string text = "|";
  for (const std::string& c : cells) text += " " + c + " |";
  return text + "\n";
}

std::string head(const std::vector<std::string>& cells) {
  return row(cells) + row(std::vector<std::string>(cells.size(), "---"));
}

std::string pageBody(const BenchResult& r) {
  return introduction(r) + figures(r) + severity(r) + effectsSection(r) + calibrationSection(r) +
         comparisonSection(r) + casesSection(r) + limits;
}

}  // namespace plumbline::bench
