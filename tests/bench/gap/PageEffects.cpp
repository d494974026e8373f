#include <cmath>
#include <cstdio>

#include "Page.h"
#include "gap/blind/ScoreDetection.h"

namespace plumbline::bench {

using namespace gap;

namespace {

std::string ratio(double x) {
  if (std::isinf(x)) return "more than tried";
  char text[32];
  std::snprintf(text, sizeof text, "%.1f", x);
  return text;
}

std::string ratio(const std::optional<double>& x) { return x ? ratio(*x) : "-"; }

std::string limitRow(const char* what, const DetectionLimit& limit) {
  constexpr std::size_t tooFew = 10;
  if (limit.count < tooFew) return row({what, "too few", "-", std::to_string(limit.count)});
  return row({what, (limit.below ? "at most " : "") + ratio(limit.ratio),
              "[" + ratio(limit.lower) + ", " + ratio(limit.upper) + "]", std::to_string(limit.count)});
}

std::string of(std::size_t hits, std::size_t all) {
  return all ? std::to_string(hits) + " of " + std::to_string(all) : "-";
}

}  // namespace

std::string effectsSection(const BenchResult& r) {
  std::string text =
      "\n## Where an effect is first found\n\nSeverity (gap over noise) from which on 90 % of all singles "
      "are "
      "found, from a logistic regression on its logarithm (Firth's penalty, bootstrap interval). Where even "
      "the weakest tried reach that, the weakest is given; nothing is said beyond what was tried.\n\n" +
      head({"found means", "severity at 90 %", "interval", "cases"});
  text +=
      limitRow("a verdict other than none", detectionLimit(detectionsOf(r.set, r.answers, r.robot, true)));
  text += limitRow("effect and place first", detectionLimit(detectionsOf(r.set, r.answers, r.robot, false)));
  text +=
      "\nPer effect there are too few cases for a regression. Instead: the severity from which on every "
      "single was named first at its place (- where the strongest one was not), the weakest found, and the "
      "strongest missed, of any severity.\n\n" +
      head({"effect", "singles found", "all found from", "weakest found", "strongest missed",
            "found in mixtures"});
  for (const EffectScore& e : effectScores(r.set, r.answers, r.robot))
    text += row({"`" + e.effect + "`", of(e.found, e.singles), ratio(e.allFoundFrom), ratio(e.weakestFound),
                 ratio(e.strongestMissed), of(e.foundInMixtures, e.ofMixtures)});
  return text;
}

std::string calibrationSection(const BenchResult& r) {
  std::string text =
      "\n## What a probability is worth\n\nEffects named under the verdict `effect`, by the probability "
      "stated; calibrated answers are right as often as they say. Expected calibration error: " +
      cell(r.own.figure("ece")) + ".\n\n" + head({"stated", "mean stated", "share right", "answers"});
  for (const CalibrationBin& bin : r.own.calibration) {
    char range[32];
    std::snprintf(range, sizeof range, "%.1f to %.1f", bin.from, bin.to);
    text += row({range, bin.right.count ? number(bin.stated) : "-", cell(bin.right),
                 std::to_string(bin.right.count)});
  }
  return text;
}

}  // namespace plumbline::bench
