// bin/gap apply: the effects that an answer found, as a configuration of the simulators.
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "framework/WriteFile.h"
#include "gap/report/AnswerCauses.h"
#include "gap/report/AnswerFile.h"
#include "main/gap/Commands.h"

namespace plumbline::gap {

namespace {

struct ApplyOptions {
  std::string answer, output;
  bool anyway = false, further = false;
};

void apply(const ApplyOptions& options) {
  const nlohmann::json answer = readAnswer(options.answer);
  const std::string verdict = answer["verdict"];
  if (verdict == "unknown" && !options.anyway && !options.further)
    throw ConfigurationError(
        options.answer +
        ": the verdict is unknown, its effects are not the cause; --anyway writes the nearest, --further the "
        "values of all joints");
  std::vector<simulation::EffectSetting> effects;
  if (options.further)
    effects = furtherSettingsOf(answer, options.answer);
  else if (verdict != "none")
    effects = replayedSettingsOf(answer, options.answer);
  std::string comment =
      options.further
          ? "Values of all joints that bin/gap diagnose fitted at once; they do not say what is missing"
          : "What bin/gap diagnose found missing";
  if (answer.contains("robot") && answer["robot"].is_string())
    comment += " from the model of " + answer["robot"].get<std::string>();
  comment += "; verdict: " + verdict + ".\nUse: " +
             (options.further ? "bin/optimizewalk --effects FILE (without command_delay)"
                              : "bin/simulator --effects FILE") +
             ", bin/gap record --effects FILE\n";
  for (const nlohmann::json& effect : answer["effects"])
    if (!options.further && verdict != "none" && effect.contains("probability") &&
        effect["probability"].is_number()) {
      char sure[32];
      std::snprintf(sure, sizeof sure, "%.0f", 100 * effect["probability"].get<double>());
      comment += effect["effect"].get<std::string>() + ": probability " + sure + " %\n";
    }
  // A comment ends at the end of its line, so texts of others must not have a line break.
  for (char& c : comment)
    if (static_cast<unsigned char>(c) < ' ' && c != '\n') c = ' ';
  writeFile(options.output, simulation::effectsText(effects, comment));
  std::printf("%zu %s written to %s\n", effects.size(), effects.size() == 1 ? "effect" : "effects",
              options.output.c_str());
}

}  // namespace

void addApply(CommandLine& app) {
  auto options = std::make_shared<ApplyOptions>();
  CommandLine command = app.command("apply", "Writes the effects found as a simulator's configuration");
  command.option("answer", options->answer, "The file that bin/gap diagnose --json wrote").required();
  command.option("-o,--output", options->output, "File of effects, doc/reference/effects-file.md").required();
  command.flag("--anyway", options->anyway, "Also if the verdict is unknown");
  command.flag("--further", options->further,
               "The values of all joints that were fitted at once (gap.further)");
  command.footer(
      "Examples:\n  bin/gap apply answer.json -o effects.yaml\n"
      "  bin/gap record --program hang_fast --effects effects.yaml -o check");
  command.whenChosen([options] { apply(*options); });
}

}  // namespace plumbline::gap
