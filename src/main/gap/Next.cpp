// bin/gap next: designs the motion that separates what an answer leaves open.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "framework/WriteFile.h"
#include "gap/record/ExcitationFile.h"
#include "gap/report/AnswerCauses.h"
#include "gap/report/AnswerFile.h"
#include "gap/report/NextMotion.h"
#include "main/gap/Commands.h"
#include "main/gap/ProgressLine.h"
#include "main/gap/RobotOption.h"

namespace plumbline::gap {

namespace {

struct NextOptions {
  std::string answer, robot, output;
};

/// What is to come apart, and how that is said.
struct Question {
  std::vector<Explanation> explanations;
  std::vector<int> joints;
  bool fromFirst = true;
  std::string text;
};

Question questionOf(const AnswerCauses& found, const nlohmann::json& answer, const Mechanism& robot,
                    const std::string& path) {
  Question question;
  const std::string verdict = answer["verdict"];
  if (verdict == "unknown") {
    std::string signal;
    if (answer.contains("worst") && answer["worst"].is_object())
      for (const char* key : {"signal_after", "signal"})
        if (signal.empty() && answer["worst"].contains(key) && answer["worst"][key].is_string())
          signal = answer["worst"][key];
    int joint = robot.jointIndex(signal.substr(signal.find('.') + 1));
    if (joint < 0 && !found.causes.empty() && found.causes.front().place.site == Site::joint)
      joint = found.causes.front().place.index;
    if (joint < 0)
      throw ConfigurationError(path +
                               ": the verdict is unknown and no joint shows it; record the standard battery");
    question.explanations = suspectsAt(robot, joint);
    question.joints = {joint};
    question.fromFirst = false;
    question.text = "what could be behind the gap at " + robot.joints[static_cast<std::size_t>(joint)].name;
    return question;
  }
  if (found.causes.empty())
    throw ConfigurationError(path +
                             ": the verdict is none, there is nothing to separate; faster moves and higher "
                             "loads would show smaller effects");
  question.explanations = {found.causes};
  if (!found.rivals.empty()) {
    const AnswerRival& rival = found.rivals.front();
    Explanation other = found.causes;
    other[rival.effect] = rival.cause;
    question.explanations.push_back(other);
    question.text = describe(found.causes[rival.effect]) + " from " + describe(rival.cause);
    return question;
  }
  // Without a rival the doubt is about the least certain cause: is it one at all?
  std::size_t weakest = 0;
  for (std::size_t i = 1; i < found.causes.size(); ++i)
    if (found.probabilities[i] < found.probabilities[weakest]) weakest = i;
  const Cause& cause = found.causes[weakest];
  question.text = describe(cause) + " from everything else at its place";
  for (const int joint : jointsShowing(robot, cause.place))
    for (const Explanation& suspect : suspectsAt(robot, joint)) {
      if (suspect.front().effect == cause.effect) continue;
      if (cause.place.site == Site::joint && joint != cause.place.index) continue;
      Explanation other = found.causes;
      other[weakest] = suspect.front();
      question.explanations.push_back(other);
      if (question.explanations.size() > 6) return question;
    }
  return question;
}

void next(const NextOptions& options) {
  const nlohmann::json answer = readAnswer(options.answer);
  const std::string name =
      answer.contains("robot") && answer["robot"].is_string() ? answer["robot"].get<std::string>() : "";
  if (name.empty() && options.robot.empty())
    throw ConfigurationError(options.answer + ": does not say which robot it is about: name it with --robot");
  const Mechanism robot = robotOf(options.robot, name);
  const Question question =
      questionOf(causesOf(answer, options.answer, robot), answer, robot, options.answer);
  NextMotionOptions search;
  search.joints = question.joints;
  search.fromFirst = question.fromFirst;
  NextMotion found;
  {
    ProgressLine line(false);
    line.tell("trying motions", 0);
    search.progress = [&line](double share) { line.tell("trying motions", share); };
    found = findNextMotion(robot, question.explanations, search);
  }
  if (!options.output.empty()) writeFile(options.output, excitationText(found.program, robot));
  std::printf("To tell %s:\n  %-18s %6.2f times the noise: %s\n", question.text.c_str(),
              found.best.name.c_str(), found.best.separation, found.program.about.c_str());
  for (std::size_t i = 0; i < std::min<std::size_t>(4, found.others.size()); ++i)
    std::printf("  %-18s %6.2f\n", found.others[i].name.c_str(), found.others[i].separation);
  if (found.best.separation < 0.1)
    std::printf("No motion of these tells them apart; a sensor behind the gear or a known load may.\n");
  if (!options.output.empty())
    std::printf("Written to %s; on a simulated robot: bin/gap record --program %s -o next\n",
                options.output.c_str(), options.output.c_str());
}

}  // namespace

void addNext(CLI::App& app) {
  auto options = std::make_shared<NextOptions>();
  CLI::App* command =
      app.add_subcommand("next", "Designs the motion that separates what an answer leaves open");
  command->add_option("answer", options->answer, "The file that bin/gap diagnose --json wrote")->required();
  command->add_option("-o,--output", options->output, "Write the excitation program here");
  command->add_option("--robot", options->robot, "URDF or JSON file, or a name [the answer's robot]");
  command->footer("Example:\n  bin/gap next answer.json -o next.yaml");
  command->callback([options] { next(*options); });
}

}  // namespace plumbline::gap
