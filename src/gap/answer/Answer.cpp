#include "gap/answer/Answer.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "gap/answer/Behavior.h"
#include "gap/diagnosis/GapMap.h"
#include "gap/run/Channel.h"

namespace plumbline::gap {

namespace {

using nlohmann::json;

constexpr std::size_t maxCells = 60, maxOverlays = 6, maxPoints = 1500;

/// So many significant digits, so that files stay small and equal.
double rounded(double value, int digits = 6) {
  if (!std::isfinite(value) || value == 0) return value;
  const double scale = std::pow(10.0, digits - 1 - std::floor(std::log10(std::abs(value))));
  return std::round(value * scale) / scale;
}

json number(double value, int digits = 6) {
  return std::isfinite(value) ? json(rounded(value, digits)) : json(nullptr);
}

std::string sentenceOf(const Cause& cause) {
  std::string text(cause.effect->sentence);
  const std::string place = cause.place.at == "*" ? "every joint" : cause.place.at;
  for (std::size_t at = 0; (at = text.find("{at}")) != std::string::npos;) text.replace(at, 4, place);
  const std::string inactiveIn = describeInactiveIn(cause);
  return inactiveIn.empty() ? text : text + " It was " + inactiveIn + ".";
}

/// The folders of what was diagnosed, each once.
std::vector<std::string> recordingsOf(const std::vector<Trial>& trials) {
  std::vector<std::string> recordings;
  for (const Trial& trial : trials)
    if (std::ranges::find(recordings, trial.recording) == recordings.end())
      recordings.push_back(trial.recording);
  return recordings;
}

json findingJson(const Finding& finding, const std::vector<std::string>& recordings) {
  json j = causeJson(finding.cause);
  j["interval"] = {number(finding.lower), number(finding.upper)};
  j["probability"] = number(finding.probability, 4);
  j["gap_closed"] = number(finding.closedAlone, 4);
  j["closed_alone"] = number(finding.closedAlone, 4);
  j["closed_last"] = number(finding.closedLast, 4);
  if (finding.evidence) j["evidence"] = number(*finding.evidence, 4);
  j["sentence"] = sentenceOf(finding.cause);
  if (!finding.cause.inactiveIn.empty()) {
    j["not_in"] = finding.cause.inactiveIn;
    j["expected_elsewhere"] = isExpectedElsewhere(finding.cause, recordings);
  }
  j["confounded_with"] = json::array();
  for (const Rival& rival : finding.rivals) {
    json other = causeJson(rival.cause);
    other["probability"] = number(rival.probability, 4);
    other["sentence"] = sentenceOf(rival.cause);
    j["confounded_with"].push_back(other);
  }
  return j;
}

std::string unitOf(const Signal& signal) {
  switch (signal.kind) {
    case SignalKind::position:
      return "rad";
    case SignalKind::velocity:
    case SignalKind::gyro:
      return "rad/s";
    case SignalKind::torque:
      return "N m";
    case SignalKind::current:
      return "A";
    case SignalKind::accelerometer:
      return "m/s^2";
    case SignalKind::force:
      return "N";
    default:
      return "";
  }
}

/// The channels that the nominal model misses most, each in the run that shows it best.
json overlays(const Evaluator& evaluator, const std::vector<Prediction>& nominal) {
  struct Choice {
    double size;
    std::size_t trial, signal;
  };
  const Evidence& data = evaluator.evidence();
  std::vector<Choice> choices;
  for (std::size_t t = 0; t < data.trials().size(); ++t)
    for (std::size_t s = 0; s < data.trials()[t].signals.size(); ++s) {
      const Signal& signal = data.trials()[t].signals[s];
      const auto& predicted = nominal[t].values[s];
      if (!Evidence::counts(signal) || predicted.empty()) continue;
      double sum = 0, n = 1e-9;
      for (std::size_t k = 0; k < predicted.size(); ++k) {
        const double r = signal.values[k] - predicted[k];
        if (data.weights(t, s)[k] <= 0 || !std::isfinite(r)) continue;
        sum += data.weights(t, s)[k] * r * r;
        ++n;
      }
      choices.push_back({sum / n, t, s});
    }
  std::stable_sort(choices.begin(), choices.end(),
                   [](const Choice& a, const Choice& b) { return a.size > b.size; });
  json result = json::array();
  std::vector<std::string> names;
  for (const Choice& choice : choices) {
    if (result.size() >= maxOverlays) break;
    const Trial& trial = data.trials()[choice.trial];
    const Signal& signal = trial.signals[choice.signal];
    if (std::ranges::find(names, signal.name) != names.end()) continue;
    names.push_back(signal.name);
    json j;
    j["run"] = choice.trial;
    j["signal"] = signal.name;
    j["unit"] = unitOf(signal);
    const std::size_t every = std::max<std::size_t>(1, (trial.cycles() + maxPoints - 1) / maxPoints);
    for (const char* key : {"t", "measured", "nominal", "corrected"}) j[key] = json::array();
    for (std::size_t k = 0; k < trial.cycles(); k += every) {
      j["t"].push_back(number(trial.time[k]));
      j["measured"].push_back(number(signal.values[k]));
      j["nominal"].push_back(number(nominal[choice.trial].values[choice.signal][k]));
      j["corrected"].push_back(number(evaluator.basePrediction(choice.trial).values[choice.signal][k]));
    }
    result.push_back(std::move(j));
  }
  return result;
}

}  // namespace

nlohmann::json causeJson(const Cause& cause) {
  json j;
  j["effect"] = cause.effect->id;
  j["at"] = cause.place.at;
  j["axis"] = cause.place.axis ? json(std::string(1, cause.place.axis)) : json(nullptr);
  j["value"] = number(cause.value);
  j["unit"] = cause.effect->unit;
  const auto& variants = cause.effect->variants;
  j["variant"] = variants.empty() ? json(nullptr) : json(variants[static_cast<std::size_t>(cause.variant)]);
  return j;
}

std::string verdictSentence(const Diagnosis& diagnosis) {
  char size[160];
  if (diagnosis.verdict == Verdict::none) {
    std::snprintf(size, sizeof size,
                  "The nominal model explains these runs down to their noise (worst channel %.1f times the "
                  "noise beyond it).",
                  diagnosis.worstBefore);
    return size;
  }
  std::string causes;
  for (const Finding& finding : diagnosis.findings) {
    char sure[32];
    std::snprintf(sure, sizeof sure, " (%.0f %%)", 100 * finding.probability);
    causes += (causes.empty() ? "" : ", ") + describe(finding.cause) + sure;
  }
  if (diagnosis.verdict == Verdict::effect) {
    std::snprintf(size, sizeof size, "; it closes %.0f %% of the gap on data that were not used for the fit.",
                  100 * std::min(1.0, diagnosis.gap.closed()));
    return "Missing from the model: " + causes + size;
  }
  if (!diagnosis.sensorOff.empty()) {
    std::snprintf(size, sizeof size,
                  "Something is missing that no effect of the library explains: with a fixed base, %s is "
                  "off by %.2f times its noise on average.",
                  diagnosis.sensorOff.c_str(), diagnosis.sensorOffBy);
  } else {
    std::snprintf(
        size, sizeof size,
        "Something is missing that no effect of the library explains: %.1f times the noise remain in the "
        "worst channel, %s.",
        diagnosis.worstAfter, diagnosis.worstSignalAfter.c_str());
  }
  return size + (causes.empty() ? std::string()
                                : " The nearest explanation is " + causes + ", and it is not enough.");
}

namespace {

/// What to move to see more of a signal, which may be empty or of no joint.
std::string moved(const std::string& signal) {
  const auto channel = parseChannel(signal);
  return channel && channel->ofJoint() ? "Move only " + channel->place : "Move one joint at a time";
}

}  // namespace

std::string suggestion(const Diagnosis& diagnosis, const Evidence& evidence) {
  const bool repeats = [&] {
    const auto& trials = evidence.trials();
    for (std::size_t a = 0; a < trials.size(); ++a)
      for (std::size_t b = a + 1; b < trials.size(); ++b)
        if (isRepeat(trials[a], trials[b])) return true;
    return false;
  }();
  const std::string again = repeats ? "" : " Record one motion twice: only repeats show what is noise.";
  if (diagnosis.verdict == Verdict::none)
    return "Nothing is needed for these motions; faster moves, higher loads and slow reversals would show "
           "smaller effects." +
           again;
  for (const Finding& finding : diagnosis.findings)
    if (!finding.rivals.empty()) {
      const Effect &a = *finding.cause.effect, &b = *finding.rivals.front().cause.effect;
      return std::string(a.id) + " and " + std::string(b.id) + " at " + finding.cause.place.at +
             " are separated by: " + std::string(a.exposedBy) +
             (a.exposedBy == b.exposedBy ? ", larger and at other loads"
                                         : "; and " + std::string(b.exposedBy)) +
             "." + again;
    }
  if (diagnosis.verdict == Verdict::unknown)
    return moved(diagnosis.worstSignal) +
           ": slowly through its range in both directions, at several loads, then the same fast. This shows "
           "what depends on position, speed, load or time." +
           again;
  return "To make the value more certain: " +
         std::string(diagnosis.findings.front().cause.effect->exposedBy) + " at " +
         diagnosis.findings.front().cause.place.at + "." + again;
}

std::string answerJson(const AnswerInput& input, const Diagnosis& diagnosis, Evaluator& evaluator) {
  evaluator.setBase({});
  std::vector<Prediction> nominal;
  for (std::size_t t = 0; t < evaluator.evidence().trials().size(); ++t)
    nominal.push_back(evaluator.basePrediction(t));
  const std::vector<GapCell> cells = gapCells(evaluator);
  const std::vector<GapTrack> before = gapTracks(evaluator);
  evaluator.setBase(diagnosis.replayed());
  const std::vector<GapTrack> after = gapTracks(evaluator);

  json j;
  j["verdict"] = nameOf(diagnosis.verdict);
  j["sentence"] = verdictSentence(diagnosis);
  j["robot"] = input.robot;
  j["where"] = json::array();
  j["map"]["cells"] = json::array();
  for (const GapCell& cell : cells) {
    const json row = {{"signal", cell.signal},
                      {"phase", nameOf(cell.phase)},
                      {"gap_rms", number(cell.gap)},
                      {"noise_rms", number(cell.noise)},
                      {"share", number(cell.share, 4)}};
    if (cell.share >= 0.005 && j["where"].size() < 20) j["where"].push_back(row);
    if (j["map"]["cells"].size() < maxCells * 4) j["map"]["cells"].push_back(row);
  }
  j["map"]["time"] = json::array();
  for (std::size_t t = 0; t < before.size(); ++t) {
    json track = {{"run", t}, {"start", json::array()}, {"before", json::array()}, {"after", json::array()}};
    for (std::size_t b = 0; b < before[t].start.size(); ++b) {
      track["start"].push_back(number(before[t].start[b]));
      track["before"].push_back(number(before[t].size[b], 4));
      track["after"].push_back(number(after[t].size[b], 4));
    }
    j["map"]["time"].push_back(track);
  }
  const std::vector<std::string> recordings = recordingsOf(evaluator.evidence().trials());
  j["effects"] = json::array();
  for (const Finding& finding : diagnosis.findings) j["effects"].push_back(findingJson(finding, recordings));
  j["gap"] = {{"before", number(diagnosis.gap.before)},
              {"after", number(diagnosis.gap.after)},
              {"floor", number(diagnosis.gap.floor)},
              {"closed", number(std::min(1.0, diagnosis.gap.closed()), 4)},
              {"held_out", true},
              {"unit", "noise of each signal"}};
  for (const Cause& cause : diagnosis.jointValues)
    if (isExpectedElsewhere(cause, recordings)) j["gap"]["model"].push_back(causeJson(cause));
  j["worst"] = {{"before", number(diagnosis.worstBefore, 4)},
                {"after", number(diagnosis.worstAfter, 4)},
                {"signal", diagnosis.worstSignal},
                {"signal_after", diagnosis.worstSignalAfter}};
  j["known_probability"] = number(diagnosis.knownProbability, 4);
  j["next_motion"] =
      input.nextMotion.empty() ? suggestion(diagnosis, evaluator.evidence()) : input.nextMotion;
  j["per_signal"] = json::array();
  for (const SignalGap& gap : signalGaps(evaluator, nominal))
    j["per_signal"].push_back({{"signal", gap.signal},
                               {"before", number(gap.before)},
                               {"after", number(gap.after)},
                               {"floor", number(gap.floor)}});
  j["overlays"] = overlays(evaluator, nominal);
  j["behaviour"] = json::array();
  for (const Behavior& b : behaviors(evaluator, nominal))
    j["behaviour"].push_back({{"what", b.name},
                              {"unit", b.unit},
                              {"measured", number(b.measured)},
                              {"nominal", number(b.nominal)},
                              {"corrected", number(b.corrected)}});
  j["remarks"] = input.remarks;
  j["servo_settings"] = settingsJson(input.settings);
  j["runs"] = json::array();
  for (const RunNotes& run : input.runs) {
    json left = json::array();
    for (const RunWarning& warning : run.warnings)
      left.push_back({{"channel", warning.channel}, {"left_out", warning.leftOut}, {"why", warning.why}});
    j["runs"].push_back({{"folder", run.folder},
                         {"motion", run.motion},
                         {"base", run.freeBase ? "free" : "fixed"},
                         {"duration_s", number(run.duration)},
                         {"restarts", run.restarts},
                         {"left_out", left}});
  }
  return j.dump(1);
}

}  // namespace plumbline::gap
