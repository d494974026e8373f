#include "gap/blind/ScoreDetection.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <tuple>

#include "gap/blind/Bootstrap.h"
#include "gap/blind/ScoreJudge.h"
#include "gap/effects/Effects.h"

namespace plumbline::gap {

namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

struct Line {
  double a = 0, b = 0;  // logit of the probability = a + b * (x - middle)
};

/// Newton's steps on Firth's modified score: residuals y - p + h (1/2 - p), h the leverages.
Line firth(const std::vector<double>& x, const std::vector<bool>& y) {
  constexpr int most = 60;
  constexpr double longest = 2, enough = 1e-9;
  Line line;
  for (int i = 0; i < most; ++i) {
    double s0 = 1e-9, s1 = 0, s2 = 1e-9;  // Fisher information; the bits keep equal severities solvable
    for (const double v : x) {
      const double p = 1 / (1 + std::exp(-line.a - line.b * v)), w = p * (1 - p);
      s0 += w, s1 += w * v, s2 += w * v * v;
    }
    const double det = s0 * s2 - s1 * s1;
    double g0 = 0, g1 = 0;
    for (std::size_t k = 0; k < x.size(); ++k) {
      const double p = 1 / (1 + std::exp(-line.a - line.b * x[k])), w = p * (1 - p);
      const double h = w * (s2 - 2 * s1 * x[k] + s0 * x[k] * x[k]) / det;
      const double r = (y[k] ? 1 : 0) - p + h * (0.5 - p);
      g0 += r, g1 += r * x[k];
    }
    const double da = (s2 * g0 - s1 * g1) / det, db = (s0 * g1 - s1 * g0) / det;
    const double shorter = std::min(1.0, longest / std::max({longest, std::abs(da), std::abs(db)}));
    line.a += shorter * da;
    line.b += shorter * db;
    if (std::abs(da) + std::abs(db) < enough) break;
  }
  return line;
}

struct Limit {
  double ratio;
  bool below;
};

Limit limitOf(const std::vector<Detection>& trials, double share) {
  double least = infinite, most = 0, middle = 0;
  std::vector<double> x;
  std::vector<bool> y;
  for (const Detection& d : trials) {
    least = std::min(least, d.ratio);
    most = std::max(most, d.ratio);
    x.push_back(std::log(d.ratio));
    y.push_back(d.found);
    middle += x.back() / static_cast<double>(trials.size());
  }
  for (double& v : x) v -= middle;
  Line line = firth(x, y);
  if (line.b < 0) {
    // A strong effect is no harder to find for being strong: the share that is found, penalised alike.
    const auto found = static_cast<double>(std::ranges::count(y, true));
    line = {std::log((found + 0.5) / (static_cast<double>(y.size()) - found + 0.5)), 0};
  }
  const double logit = std::log(share / (1 - share));
  const auto reaches = [&](double ratio) { return line.a + line.b * (std::log(ratio) - middle) >= logit; };
  if (reaches(least)) return {least, true};
  if (!reaches(most)) return {infinite, false};
  return {std::exp(middle + (logit - line.a) / line.b), false};
}

}  // namespace

DetectionLimit detectionLimit(const std::vector<Detection>& trials, double share) {
  DetectionLimit result;
  result.count = trials.size();
  if (trials.empty()) return result;
  const Limit limit = limitOf(trials, share);
  result.ratio = limit.ratio;
  result.below = limit.below;
  std::tie(result.lower, result.upper) = bootstrapInterval(
      trials, [&](const std::vector<Detection>& again) { return limitOf(again, share).ratio; }, 400);
  return result;
}

std::vector<Detection> detectionsOf(const BlindSet& set, const std::vector<BlindAnswer>& answers,
                                    const Mechanism& robot, bool seen) {
  const BlindJudge judge(robot);
  std::vector<Detection> trials;
  for (std::size_t i = 0; i < set.cases.size(); ++i) {
    const BlindCase& c = set.cases[i];
    const std::string& verdict = answers[i].verdict;
    if (c.isSingle() && c.ratio > 0)
      trials.push_back({c.ratio, seen ? !verdict.empty() && verdict != "none" : judge.first(c, answers[i])});
  }
  return trials;
}

std::vector<EffectScore> effectScores(const BlindSet& set, const std::vector<BlindAnswer>& answers,
                                      const Mechanism& robot) {
  const BlindJudge judge(robot);
  std::vector<EffectScore> scores;
  for (const Effect* effect : effects()) {
    EffectScore score;
    score.effect = effect->id;
    std::vector<Detection> trials;
    for (std::size_t i = 0; i < set.cases.size(); ++i) {
      const BlindCase& c = set.cases[i];
      if (c.isSingle() && c.effects.front().effect == effect->id)
        trials.push_back({c.ratio, judge.first(c, answers[i])});
      if (c.kind != BlindKind::mixture) continue;
      for (const BlindEffect& e : c.effects) {
        if (e.effect != effect->id) continue;
        ++score.ofMixtures;
        score.foundInMixtures += judge.named(e, answers[i]);
      }
    }
    std::ranges::sort(trials, std::greater(), &Detection::ratio);
    for (const Detection& d : trials) {
      ++score.singles;
      score.found += d.found;
      if (d.found) {
        score.weakestFound = d.ratio;
        if (!score.strongestMissed) score.allFoundFrom = d.ratio;
      } else if (!score.strongestMissed) {
        score.strongestMissed = d.ratio;
      }
    }
    if (score.singles + score.ofMixtures > 0) scores.push_back(score);
  }
  return scores;
}

}  // namespace plumbline::gap
