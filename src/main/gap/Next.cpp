// bin/gap next: designs the motion that separates what an answer leaves open.
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "framework/ConfigurationError.h"
#include "framework/WriteFile.h"
#include "gap/record/ExcitationFile.h"
#include "gap/report/AnswerCauses.h"
#include "gap/report/AnswerFile.h"
#include "gap/report/MotionQuestion.h"
#include "gap/report/NextMotion.h"
#include "main/gap/Commands.h"
#include "main/gap/ProgressLine.h"
#include "main/gap/RobotOption.h"
#include "robot/MechanismCheck.h"

namespace plumbline::gap {

namespace {

struct NextOptions {
  std::string answer, robot, output;
};

void next(const NextOptions& options) {
  const nlohmann::json answer = readAnswer(options.answer);
  const std::string name =
      answer.contains("robot") && answer["robot"].is_string() ? answer["robot"].get<std::string>() : "";
  if (name.empty() && options.robot.empty())
    throw ConfigurationError(options.answer + ": does not name its robot: give it with --robot");
  const Mechanism robot = robotOf(options.robot, name);
  requirePositionServos(robot);
  const MotionQuestion question =
      motionQuestionOf(causesOf(answer, options.answer, robot), answer, robot, options.answer);
  NextMotionOptions search;
  search.joints = question.joints;
  search.fromFirst = question.fromFirst;
  NextMotion found;
  {
    ProgressLine line(false);
    line.update("trying motions", 0);
    search.progress = [&line](double share) { line.update("trying motions", share); };
    found = findNextMotion(robot, question.explanations, search);
  }
  if (!options.output.empty()) writeFile(options.output, excitationText(found.program, robot));
  std::printf("To separate %s:\n  %-18s %6.2f times the noise: %s\n", question.text.c_str(),
              found.best.name.c_str(), found.best.separation, found.program.about.c_str());
  for (std::size_t i = 0; i < std::min<std::size_t>(4, found.others.size()); ++i)
    std::printf("  %-18s %6.2f\n", found.others[i].name.c_str(), found.others[i].separation);
  if (found.best.separation < 0.1)
    std::printf("None of these motions separates them; a sensor behind the gear or a known load may.\n");
  if (!options.output.empty())
    std::printf("Written to %s; on a simulated robot: bin/gap record --program %s -o next\n",
                options.output.c_str(), options.output.c_str());
}

}  // namespace

void addNext(CommandLine& app) {
  auto options = std::make_shared<NextOptions>();
  CommandLine command = app.command("next", "Designs the motion that separates what an answer leaves open");
  command.option("answer", options->answer, "The file that bin/gap diagnose --json wrote").required();
  command.option("-o,--output", options->output, "Write the excitation program here");
  command.option("--robot", options->robot, "URDF or JSON file, or a name [the answer's robot]");
  command.footer("Example:\n  bin/gap next answer.json -o next.yaml");
  command.whenChosen([options] { next(*options); });
}

}  // namespace plumbline::gap
