#include "gap/blind/BeyondReference.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "gap/blind/ScoreJudge.h"
#include "gap/effects/Effects.h"

namespace plumbline::gap {

namespace {

constexpr double quarter = 0.25;

/// Distance of a value from nominal, which adds: of factors the logarithm.
double sizeOf(const std::string& id, double value) {
  const Effect* effect = findEffect(id);
  if (!effect) return value;
  if (effect->nominal == 1) return std::log(std::max(1e-3, value));
  return value - effect->nominal;
}

double valueOf(const std::string& id, double size) {
  const Effect* effect = findEffect(id);
  if (!effect) return size;
  return effect->nominal == 1 ? std::exp(size) : effect->nominal + size;
}

class Comparison {
public:
  Comparison(const BlindAnswer& reference, const Mechanism& robot) : reference_(reference), judge_(robot) {}

  BlindAnswer of(const BlindCase& c, const BlindAnswer& answer) const {
    if (answer.verdict.empty()) return answer;
    BlindAnswer result = answer;
    result.effects.clear();
    for (const BlindAnswer::Named& named : answer.effects) addBeyond(c, named, result);
    if (answer.verdict != "unknown") {
      for (const BlindAnswer::Named& old : reference_.effects)
        if (!find(answer, old)) addCancelled(c, old, result);
      result.verdict = result.effects.empty() ? "none" : "effect";
    }
    if (result.verdict == "unknown" && reference_.verdict == "unknown") result.verdict = "none";
    return result;
  }

private:
  const BlindAnswer::Named* find(const BlindAnswer& answer, const NamedCause& cause) const {
    for (const BlindAnswer::Named& named : answer.effects)
      if (judge_.same({cause.effect, cause.at, cause.axis, cause.value, {}, {}}, named)) return &named;
    return nullptr;
  }

  void addBeyond(const BlindCase& c, BlindAnswer::Named named, BlindAnswer& result) const {
    if (const BlindAnswer::Named* old = find(reference_, named)) {
      const double before = sizeOf(old->effect, old->value), now = sizeOf(named.effect, named.value);
      if (std::abs(now - before) <= quarter * std::abs(before)) return;
      named.value = valueOf(named.effect, now - before);
    }
    for (const BlindEffect& planted : c.effects)
      if (planted.effect == named.effect && judge_.same(planted, named) &&
          sizeOf(named.effect, named.value) * sizeOf(planted.effect, planted.value) < 0)
        named.effect = "SIGN:" + named.effect;
    result.effects.push_back(named);
  }

  void addCancelled(const BlindCase& c, BlindAnswer::Named old, BlindAnswer& result) const {
    const double moved = -sizeOf(old.effect, old.value);
    for (const BlindEffect& planted : c.effects) {
      const double wanted = sizeOf(planted.effect, planted.value);
      if (planted.effect != old.effect || !judge_.same(planted, old) ||
          std::abs(moved - wanted) > quarter * std::abs(wanted))
        continue;
      old.value = valueOf(old.effect, moved);
      result.effects.push_back(old);
    }
  }

  const BlindAnswer& reference_;
  const BlindJudge judge_;
};

}  // namespace

std::vector<BlindAnswer> beyondReference(const BlindSet& set, std::vector<BlindAnswer> answers,
                                         const Mechanism& robot) {
  const auto reference = std::ranges::find(set.cases, true, &BlindCase::reference);
  if (reference == set.cases.end())
    throw std::runtime_error("the set has no case in which nothing is planted; make it anew");
  const BlindAnswer own = answers[static_cast<std::size_t>(reference - set.cases.begin())];
  if (own.verdict.empty())
    throw std::runtime_error("there is no answer to case " + reference->name +
                             ", with which all others are compared; bin/gap diagnose it, too");
  const Comparison comparison(own, robot);
  for (std::size_t i = 0; i < answers.size(); ++i) answers[i] = comparison.of(set.cases[i], answers[i]);
  return answers;
}

}  // namespace plumbline::gap
