#include "gap/answer/SetsAnswer.h"

#include "gap/inference/JointValues.h"
#include "gap/inference/LeftJson.h"

namespace plumbline::gap {
namespace {

nlohmann::json furtherJson(const AllJointFit& further) {
  if (further.parameters == 0) return nullptr;
  nlohmann::json runs = nlohmann::json::array(), model = nlohmann::json::array();
  for (const RecordingLeft& left : further.leftOut) runs.push_back(leftJson(left));
  for (const Cause& cause : further.model) model.push_back(causeJson(cause));
  return {{"closed", further.closed},
          {"parameters", further.parameters},
          {"sentence", further.sentence()},
          {"attributable", false},
          {"claimed", further.claim.closed},
          {"claimed_interval", {further.claim.lower, further.claim.upper}},
          {"model", model},
          {"runs", runs}};
}

}  // namespace

nlohmann::json setsAnswer(const Inference& inference, const AllJointFit& further, const AnswerInput& input,
                          const Evidence& evidence, const Mechanism& robot) {
  Evaluator evaluator(robot, evidence);
  if (inference.lost.any()) evaluator.setLostCycles(inference.lost.cycles);
  nlohmann::json answer = nlohmann::json::parse(answerJson(input, inference.diagnosis, evaluator));
  answer["method"] = "sets";
  const std::string more = further.sentence();
  answer["sentence"] = inference.sentence() + (more.empty() ? "" : " " + more);
  nlohmann::json& gap = answer["gap"];
  gap["closed"] = inference.claim.closed;
  gap["closed_interval"] = {inference.claim.lower, inference.claim.upper};
  gap["closed_left_out"] = meanClosedToNoise(inference.leftOut);
  gap["unit"] = "rad, or m: positions of recordings left out";
  gap["left_out"] = inference.stretchesOfOne ? "stretches of the one recording" : "recordings";
  gap["runs"] = nlohmann::json::array();
  for (const RecordingLeft& left : inference.leftOut) gap["runs"].push_back(leftJson(left));
  gap["further"] = furtherJson(further);
  for (const std::string& line : inference.notUsed) answer["remarks"].push_back(line);
  for (const std::string& line : inference.onlyIn) answer["remarks"].push_back(line);
  if (const std::string line = inference.runToRun(); !line.empty()) answer["remarks"].push_back(line);
  answer["replays"] = inference.replays;
  return answer;
}

}  // namespace plumbline::gap
