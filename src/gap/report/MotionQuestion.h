#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gap/diagnosis/Diagnosis.h"
#include "gap/report/AnswerCauses.h"

namespace plumbline::gap {

/// What a diagnosis leaves open, as a task for findNextMotion: explanations that a motion should separate.
struct MotionQuestion {
  std::vector<Explanation> explanations;
  std::vector<int> joints;  ///< that may move; empty: those the explanations are about
  bool fromFirst = true;    ///< the first is to be separated from each of the others
  std::string text;         ///< what is to be told apart, in words
};

/// Of an answer that readAnswer checked and causesOf resolved. An unknown cause: what could be behind the gap
/// at the joint that shows it; a rival: the found cause and the likeliest rival; otherwise the least certain
/// cause and what else could be at its place. Throws ConfigurationError, with the file's name, where no
/// motion would help.
MotionQuestion motionQuestionOf(const AnswerCauses& found, const nlohmann::json& answer,
                                const Mechanism& robot, const std::string& file);

/// The motion that separates the likeliest rival from the cause it would replace, in words; empty where no
/// rival has a probability of 5 % or more, or no motion can be tried on this robot.
std::string separatingMotion(const Mechanism& robot, const Diagnosis& diagnosis);

}  // namespace plumbline::gap
