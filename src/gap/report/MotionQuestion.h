#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gap/diagnosis/Diagnosis.h"
#include "gap/report/AnswerCauses.h"

namespace plumbline::gap {

/// Open question of a diagnosis, as a task for findNextMotion: explanations that a motion should separate.
struct MotionQuestion {
  std::vector<Explanation> explanations;
  std::vector<int> joints;  ///< that may move; empty: those of the explanations
  bool fromFirst = true;    ///< separate the first from each of the others
  std::string text;         ///< what should be separated, as a text
};

/// The question for an answer that readAnswer checked and causesOf resolved. For an unknown cause: possible
/// causes of the gap at the joint that shows it. With a rival: the found cause and the most probable rival.
/// Otherwise: the least certain cause and other effects at its place. Throws ConfigurationError, with the
/// file's name, if no motion would help.
MotionQuestion motionQuestionOf(const AnswerCauses& found, const nlohmann::json& answer,
                                const Mechanism& robot, const std::string& file);

/// The motion that separates the most probable rival from the cause it would replace, as a text. Empty if no
/// rival has a probability of 5 % or more, or no motion can be tried on this robot.
std::string separatingMotion(const Mechanism& robot, const Diagnosis& diagnosis);

}  // namespace plumbline::gap
