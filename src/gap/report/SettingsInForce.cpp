#include "gap/report/SettingsInForce.h"

#include <algorithm>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "gap/diagnosis/ExplanationFile.h"
#include "gap/inference/HoldOut.h"
#include "gap/report/AnswerCauses.h"

namespace plumbline::gap {

std::vector<SettingChoice> settingChoices(const nlohmann::json& answer, const std::string& path,
                                          const Mechanism& robot, const Explanation& replayed) {
  std::vector<SettingChoice> choices;
  const Explanation named = causesOf(settingsOf(answer, path), robot);
  for (std::size_t i = 0; i < named.size(); ++i) {
    const nlohmann::json& effect = answer["effects"][i];
    const auto ofIt = [&](const Cause& cause) { return cause.effect == named[i].effect; };
    if (!effect.contains("not_in") || std::ranges::any_of(choices, [&](const SettingChoice& known) {
          return known.effect == named[i].effect->id;
        }))
      continue;
    SettingChoice& choice = choices.emplace_back();
    choice.effect = named[i].effect->id;
    choice.with = choice.without = replayed;
    std::erase_if(choice.without, ofIt);
    choice.expected = choice.without.size() < replayed.size();
    if (choice.expected) continue;
    std::ranges::copy_if(named, std::back_inserter(choice.with), ofIt);
  }
  return choices;
}

std::string SettingSeen::sentence() const {
  char text[240];
  const double now = expected ? with : without, other = expected ? without : with;
  std::snprintf(text, sizeof text,
                "%s %s %.1f mrad are left, %s it %.1f: it may have been recorded %s that setting.",
                expected ? "with" : "without", effect.c_str(), 1e3 * now, expected ? "without" : "with",
                1e3 * other, expected ? "without" : "with");
  return folder + ": " + text;
}

std::vector<SettingSeen> settingsSeen(const Trial& trial, const Prediction& nominal, double expectedLeft,
                                      const std::vector<SettingChoice>& choices) {
  std::vector<SettingSeen> seen;
  seen.reserve(choices.size());
  for (const SettingChoice& choice : choices) {
    const double otherLeft =
        leftIn(trial, nominal, {{0, choice.expected ? choice.without : choice.with}}).after;
    seen.push_back({trial.recording, choice.effect, choice.expected,
                    choice.expected ? expectedLeft : otherLeft, choice.expected ? otherLeft : expectedLeft});
  }
  return seen;
}

}  // namespace plumbline::gap
