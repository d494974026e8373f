#include <cstdio>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "framework/ConfigurationError.h"
#include "gap/blind/BlindScore.h"
#include "gap/report/AnswerFile.h"

namespace plumbline::gap {

namespace {

using nlohmann::json;

NamedCause causeOf(const json& j) {
  NamedCause cause;
  cause.effect = j.at("effect");
  cause.at = j.at("at");
  if (j.contains("axis") && j["axis"].is_string()) cause.axis = j["axis"];
  if (j.contains("value") && j["value"].is_number()) cause.value = j["value"];
  if (j.contains("probability") && j["probability"].is_number()) cause.probability = j["probability"];
  return cause;
}

BlindAnswer answerOf(const json& j) {
  BlindAnswer answer;
  answer.verdict = j.at("verdict");
  for (const json& e : j.at("effects")) {
    BlindAnswer::Named named{causeOf(e), {}};
    if (e.contains("confounded_with"))
      for (const json& rival : e["confounded_with"]) named.rivals.push_back(causeOf(rival));
    answer.effects.push_back(std::move(named));
  }
  if (j.contains("gap") && j["gap"].is_object() && j["gap"].contains("closed") &&
      j["gap"]["closed"].is_number())
    answer.closed = j["gap"]["closed"].get<double>();
  return answer;
}

json figureJson(const Figure& figure) {
  json j = {{"id", figure.id}, {"what", figure.what}, {"cases", figure.count}};
  j["value"] = figure.count ? json(figure.value) : json(nullptr);
  j["interval"] = figure.count ? json({figure.lower, figure.upper}) : json(nullptr);
  return j;
}

std::string line(const Figure& figure) {
  char text[200];
  if (figure.count == 0)
    std::snprintf(text, sizeof text, "%-62s      -\n", figure.what.c_str());
  else
    std::snprintf(text, sizeof text, "%-62s %6.3f  [%.3f, %.3f]  of %zu\n", figure.what.c_str(), figure.value,
                  figure.lower, figure.upper, figure.count);
  return text;
}

}  // namespace

std::vector<BlindAnswer> readAnswers(const BlindSet& set, const std::string& folder) {
  std::vector<BlindAnswer> answers;
  std::size_t found = 0;
  for (const BlindCase& c : set.cases) {
    const std::string path = (std::filesystem::path(folder) / (c.name + ".json")).string();
    BlindAnswer answer;
    if (std::filesystem::exists(path)) {
      answer = answerOf(readAnswer(path));
      ++found;
    }
    answer.name = c.name;
    answers.push_back(std::move(answer));
  }
  if (found == 0)
    throw ConfigurationError(folder + ": no answer to any case; `bin/gap diagnose CASE --json " + folder +
                             "/<case>.json` writes one");
  return answers;
}

std::string scoreTable(const BlindScore& score) {
  std::string text;
  for (const Figure& figure : score.figures) text += line(figure);
  text += "Effect and place first by severity (gap over noise), singles:\n";
  for (const Figure& figure : score.bySeverity) text += "  " + line(figure);
  text += std::to_string(score.cases) + " cases";
  if (score.missing) text += ", " + std::to_string(score.missing) + " of them without an answer";
  return text + "\n";
}

std::string scoreJson(const BlindScore& score) {
  json j = {{"cases", score.cases}, {"missing", score.missing}};
  for (const Figure& figure : score.figures) j["figures"].push_back(figureJson(figure));
  for (const Figure& figure : score.bySeverity) j["severity"].push_back(figureJson(figure));
  for (const CalibrationBin& bin : score.calibration)
    j["calibration"].push_back({{"from", bin.from},
                                {"to", bin.to},
                                {"stated", bin.right.count ? json(bin.stated) : json(nullptr)},
                                {"right", bin.right.count ? json(bin.right.value) : json(nullptr)},
                                {"answers", bin.right.count}});
  return j.dump(1);
}

}  // namespace plumbline::gap
