#include "gap/record/Secret.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

#include "gap/record/LostCommands.h"
#include "gap/record/SimulatedRecording.h"
#include "gap/replay/Replay.h"
#include "gap/replay/TrialOf.h"
#include "math/Random.h"

namespace plumbline::gap {

namespace {

constexpr double minSize = 6, maxSize = 60;  // of an effect, in noises of the reading that shows it most

Prediction played(const Mechanism& robot, const Trial& trial, const Explanation& causes) {
  const Plant plant = plantOf(robot, causes);
  ReplayOptions options;
  const std::vector<std::uint8_t> lost = drawLostCycles(plant, trial, Random(1));
  if (!lost.empty()) options.lostCycles = &lost;
  return replay(plant, trial, options);
}

double difference(const Trial& trial, const Prediction& a, const Prediction& b) {
  if (a.fell || b.fell) return std::numeric_limits<double>::infinity();
  double most = 0;
  for (std::size_t s = 0; s < trial.signals.size(); ++s) {
    if (a.values[s].empty() || b.values[s].empty()) continue;
    double sum = 0, n = 1e-9;
    for (std::size_t k = 0; k < a.values[s].size(); ++k) {
      const double d = a.values[s][k] - b.values[s][k];
      if (!std::isfinite(d)) continue;
      sum += d * d;
      ++n;
    }
    most = std::max(most, std::sqrt(sum / n) / noiseOf(trial.signals[s]));
  }
  return most;
}

}  // namespace

Cause drawSecret(const Mechanism& robot, const std::vector<Excitation>& programs, std::uint64_t seed) {
  std::vector<Trial> trials;
  std::vector<Prediction> nominal;
  for (const Excitation& program : programs) {
    trials.push_back(trialOf(blankRun(robot, program, robot.controlHz), robot));
    nominal.push_back(played(robot, trials.back(), {}));
  }
  // A seed means the same secret, also when the library has effects that the contract does not list.
  std::vector<const Effect*> known = effects();
  std::erase_if(known, [](const Effect* effect) { return effect->order >= beyondContract; });
  Random random(seed);
  const auto pick = [&random](std::size_t n) {
    return std::min(n - 1, static_cast<std::size_t>(random.uniform() * static_cast<double>(n)));
  };
  constexpr int draws = 200, sizes = 8;
  for (int draw = 0; draw < draws; ++draw) {
    Cause cause;
    cause.effect = known[pick(known.size())];
    const std::vector<Place> places = placesOf(*cause.effect, robot);
    if (places.empty()) continue;
    cause.place = places[pick(places.size())];
    cause.variant = static_cast<int>(pick(static_cast<std::size_t>(cause.effect->numVariants())));
    const double scale = cause.effect->scaleAt(robot, cause.place);
    const double start = scale * cause.effect->starts[pick(cause.effect->starts.size())];
    const double nothing = cause.effect->nominal;
    double deviation = (start - nothing) * random.uniform(0.7, 1.4);
    for (int i = 0; i < sizes; ++i) {
      cause.value = nothing + deviation;
      if (cause.value < cause.effect->lower * scale || cause.value > cause.effect->upper * scale) break;
      double size = 0;
      for (std::size_t t = 0; t < trials.size() && size <= maxSize; ++t)
        size = std::max(size, difference(trials[t], nominal[t], played(robot, trials[t], {cause})));
      if (size >= minSize && size <= maxSize) return cause;
      deviation *= size < minSize ? 1.5 : 0.6;
    }
  }
  throw std::runtime_error("no effect of the library shows in these programs on " + robot.name +
                           "; record more of them");
}

// The stream that a text is mixed with comes from the salt alone: a seal against reading by chance.
std::string seal(const std::string& text, std::uint64_t salt) {
  Random stream(salt ^ 0x5ea1ed);
  char hex[32];
  std::snprintf(hex, sizeof hex, "%016llx", static_cast<unsigned long long>(salt));
  std::string sealed = hex;
  std::uint8_t sum = 0;
  const auto add = [&](std::uint8_t byte) {
    std::snprintf(hex, sizeof hex, "%02x", byte ^ static_cast<unsigned>(stream.next() & 0xff));
    sealed += hex;
  };
  for (const char c : text) {
    sum = static_cast<std::uint8_t>(sum * 31 + static_cast<unsigned char>(c));
    add(static_cast<std::uint8_t>(c));
  }
  add(sum);
  return sealed;
}

std::string unseal(const std::string& sealed) {
  constexpr std::size_t saltDigits = 16, most = 1 << 20;
  const auto broken = [] { return std::invalid_argument("is no sealed secret"); };
  if (sealed.size() < saltDigits + 2 || sealed.size() > most || sealed.size() % 2 ||
      sealed.find_first_not_of("0123456789abcdef") != std::string::npos)
    throw broken();
  Random stream(std::stoull(sealed.substr(0, saltDigits), nullptr, 16) ^ 0x5ea1ed);
  std::string text;
  for (std::size_t i = saltDigits; i < sealed.size(); i += 2)
    text += static_cast<char>(std::stoul(sealed.substr(i, 2), nullptr, 16) ^ (stream.next() & 0xff));
  std::uint8_t sum = 0;
  for (std::size_t i = 0; i + 1 < text.size(); ++i)
    sum = static_cast<std::uint8_t>(sum * 31 + static_cast<unsigned char>(text[i]));
  if (sum != static_cast<std::uint8_t>(text.back())) throw broken();
  text.pop_back();
  return text;
}

}  // namespace plumbline::gap
