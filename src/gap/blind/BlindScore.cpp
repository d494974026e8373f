#include "gap/blind/BlindScore.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <tuple>

#include "gap/blind/Bootstrap.h"
#include "gap/blind/Make.h"
#include "gap/blind/ScoreJudge.h"
#include "gap/effects/Effects.h"
#include "math/WilsonInterval.h"

namespace plumbline::gap {

namespace {

constexpr std::array severityBins = {0.0, 3.0, 5.0, 10.0, 20.0, 50.0};

double mean(const std::vector<double>& x) {
  double sum = 0;
  for (const double v : x) sum += v;
  return x.empty() ? 0 : sum / static_cast<double>(x.size());
}

double median(std::vector<double> x) {
  if (x.empty()) return 0;
  std::ranges::sort(x);
  const std::size_t n = x.size();
  return n % 2 ? x[n / 2] : 0.5 * (x[n / 2 - 1] + x[n / 2]);
}

template <class T>
Figure bootstrap(std::string id, std::string what, const std::vector<T>& sample,
                 const std::function<double(const std::vector<T>&)>& statistic) {
  Figure figure{std::move(id), std::move(what), statistic(sample), 0, 0, sample.size()};
  if (sample.empty()) return figure;
  std::tie(figure.lower, figure.upper) = bootstrapInterval(sample, statistic, 1000);
  return figure;
}

/// Of the distance from nominal; of the value where nominal is no number to measure from.
double parameterError(const BlindEffect& truth, double value) {
  const Effect* effect = findEffect(truth.effect);
  const bool fromNominal = effect && !effect->nominalIsNone && effect->sites != std::vector{Site::ground};
  const double from = fromNominal ? effect->nominal : 0;
  return std::abs(value - truth.value) / std::max(1e-12, std::abs(truth.value - from));
}

std::string binName(std::size_t b) {
  const auto text = [](double x) { return std::to_string(static_cast<int>(x)); };
  return b + 1 < severityBins.size() ? text(severityBins[b]) + " to " + text(severityBins[b + 1])
                                     : text(severityBins[b]) + " and more";
}

}  // namespace

Figure share(std::string id, std::string what, std::size_t hits, std::size_t count) {
  Figure figure{std::move(id), std::move(what), 0, 0, 1, count};
  if (count == 0) return figure;
  const auto found = static_cast<double>(hits), of = static_cast<double>(count);
  figure.value = found / of;
  std::tie(figure.lower, figure.upper) = wilsonInterval(found, of);
  return figure;
}

std::vector<CalibrationBin> calibrationBins(const std::vector<Graded>& graded) {
  constexpr std::size_t bins = 10;
  std::array<double, bins> sure{};
  std::array<std::size_t, bins> right{}, count{};
  for (const Graded& g : graded) {
    const auto b = std::min(bins - 1, static_cast<std::size_t>(std::clamp(g.probability, 0.0, 1.0) * bins));
    sure[b] += g.probability;
    right[b] += g.right;
    ++count[b];
  }
  std::vector<CalibrationBin> result;
  for (std::size_t b = 0; b < bins; ++b) {
    const double from = static_cast<double>(b) / bins, to = static_cast<double>(b + 1) / bins;
    const double mean = count[b] ? sure[b] / static_cast<double>(count[b]) : 0;
    result.push_back({from, to, mean, share("", "", right[b], count[b])});
  }
  return result;
}

double calibrationError(const std::vector<Graded>& graded) {
  double sum = 0;
  for (const CalibrationBin& bin : calibrationBins(graded))
    sum += static_cast<double>(bin.right.count) * std::abs(bin.stated - bin.right.value);
  return graded.empty() ? 0 : sum / static_cast<double>(graded.size());
}

const Figure& BlindScore::figure(std::string_view id) const {
  for (const Figure& f : figures)
    if (f.id == id) return f;
  throw std::invalid_argument("no figure " + std::string(id));
}

BlindScore scoreBlind(const BlindSet& set, const std::vector<BlindAnswer>& answers, const Mechanism& robot) {
  if (answers.size() != set.cases.size()) throw std::invalid_argument("not one answer per case");
  const BlindJudge judge(robot);
  BlindScore score;
  score.cases = set.cases.size();
  struct Count {
    std::size_t hits = 0, all = 0;
    void add(bool hit) { hits += hit, ++all; }
  };
  Count top1, top3, place, hard, alarms, unknown, falseUnknown, missed, nearest, extra;
  std::array<Count, severityBins.size()> bins;
  std::vector<double> f1, errors, closed;
  std::vector<std::vector<Graded>> graded;  // per case, so that cases are drawn again and not answers
  for (std::size_t i = 0; i < set.cases.size(); ++i) {
    const BlindCase& c = set.cases[i];
    const BlindAnswer& a = answers[i];
    if (c.reference) continue;  // the others are compared with it
    score.missing += a.verdict.empty();
    const bool single = c.isSingle();
    if (single) {
      std::size_t b = severityBins.size() - 1;
      while (b > 0 && c.ratio < severityBins[b]) --b;
      bins[b].add(judge.first(c, a));
    }
    if (c.kind != BlindKind::none && c.ratio < leastRatio) continue;
    if (c.kind == BlindKind::none) alarms.add(a.verdict != "none");
    if (c.kind == BlindKind::outside)
      unknown.add(a.verdict == "unknown");
    else
      falseUnknown.add(a.verdict == "unknown");
    if (c.inLibrary()) missed.add(a.verdict == "none");
    if (single && a.verdict == "unknown" && !a.effects.empty())
      nearest.add(judge.same(c.effects.front(), a.effects.front()));
    if (single) {
      top1.add(judge.first(c, a));
      top3.add(judge.amongThree(c, a));
      place.add(judge.placeFirst(c, a));
      if (c.kind == BlindKind::hard) hard.add(judge.first(c, a));
      extra.add(a.verdict == "effect" && a.effects.size() > 1);
    }
    if (c.kind == BlindKind::mixture) f1.push_back(judge.setF1(c, a));
    if (c.inLibrary()) closed.push_back(std::clamp(a.closed.value_or(0), 0.0, 1.0));
    std::vector<Graded> mine;
    if (a.verdict == "effect")
      for (const BlindAnswer::Named& named : a.effects) {
        const auto it = std::ranges::find_if(c.effects, [&](const BlindEffect& e) {
          return c.kind != BlindKind::outside && judge.same(e, named);
        });
        mine.push_back({named.probability, it != c.effects.end()});
        if (it != c.effects.end() && it->effect == named.effect)
          errors.push_back(parameterError(*it, named.value));
      }
    if (!mine.empty()) graded.push_back(std::move(mine));
  }
  auto& f = score.figures;
  f.push_back(share("top1", "effect and place first, singles", top1.hits, top1.all));
  f.push_back(share("top3", "effect and place among three, singles", top3.hits, top3.all));
  f.push_back(share("place", "place first, singles", place.hits, place.all));
  f.push_back(share("hard", "effect and place first, pairs that look alike", hard.hits, hard.all));
  f.push_back(
      share("false_alarms", "an answer other than none where there is no effect", alarms.hits, alarms.all));
  f.push_back(share("missed", "none where an effect of the library is there", missed.hits, missed.all));
  f.push_back(
      share("unknown_found", "unknown where the effect is outside the library", unknown.hits, unknown.all));
  f.push_back(share("false_unknown", "unknown where it is not", falseUnknown.hits, falseUnknown.all));
  f.push_back(share("nearest_right", "nearest explanation right where a single was called unknown",
                    nearest.hits, nearest.all));
  f.push_back(share("extra", "more than one effect named where there is one", extra.hits, extra.all));
  f.push_back(bootstrap<double>("mixture_f1", "set F1 of mixtures, mean", f1, mean));
  f.push_back(bootstrap<double>("parameter_error", "error of the value where the effect is right, median",
                                errors, median));
  f.push_back(bootstrap<double>("gap_closed", "closable gap closed on motions left out, mean", closed, mean));
  f.push_back(bootstrap<std::vector<Graded>>("ece", "expected calibration error", graded,
                                             [](const std::vector<std::vector<Graded>>& cases) {
                                               std::vector<Graded> all;
                                               for (const auto& one : cases)
                                                 all.insert(all.end(), one.begin(), one.end());
                                               return calibrationError(all);
                                             }));
  std::vector<Graded> all;
  for (const auto& one : graded) all.insert(all.end(), one.begin(), one.end());
  score.calibration = calibrationBins(all);
  for (std::size_t b = 0; b < bins.size(); ++b)
    score.bySeverity.push_back(share("ratio_" + std::to_string(static_cast<int>(severityBins[b])), binName(b),
                                     bins[b].hits, bins[b].all));
  return score;
}

}  // namespace plumbline::gap
