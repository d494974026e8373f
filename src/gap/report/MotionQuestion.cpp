#include "gap/report/MotionQuestion.h"

#include <nlohmann/json.hpp>

#include "framework/ConfigurationError.h"
#include "gap/report/NextMotion.h"
#include "robot/MechanismCheck.h"

namespace plumbline::gap {

namespace {

constexpr double minRivalProbability = 0.05;

}  // namespace

MotionQuestion motionQuestionOf(const AnswerCauses& found, const nlohmann::json& answer,
                                const Mechanism& robot, const std::string& file) {
  MotionQuestion question;
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
      throw ConfigurationError(file +
                               ": the verdict is unknown and no joint shows it; record the standard battery");
    question.explanations = suspectsAt(robot, joint);
    question.joints = {joint};
    question.fromFirst = false;
    question.text = "what could be behind the gap at " + robot.joints[static_cast<std::size_t>(joint)].name;
    return question;
  }
  if (found.causes.empty())
    throw ConfigurationError(file +
                             ": the verdict is none, so there is nothing to separate; faster moves and "
                             "higher loads would show smaller effects");
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

std::string separatingMotion(const Mechanism& robot, const Diagnosis& diagnosis) {
  const Cause* cause = nullptr;
  const Rival* rival = nullptr;
  for (const Finding& finding : diagnosis.findings)
    for (const Rival& other : finding.rivals)
      if (other.probability >= (rival ? rival->probability : minRivalProbability)) {
        cause = &finding.cause;
        rival = &other;
      }
  if (!rival) return "";
  try {
    requirePositionServos(robot);
    return nextMotion(robot, *cause, rival->cause);
  } catch (const std::exception&) {
    return "";  // the answer then says in general what would help
  }
}

}  // namespace plumbline::gap
