#pragma once
#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gap/answer/ServoSettings.h"
#include "gap/diagnosis/Diagnosis.h"
#include "gap/run/Run.h"

namespace plumbline::gap {

/// What an answer says about the runs that it uses.
struct RunNotes {
  std::string folder, motion;
  bool freeBase = false;
  double duration = 0;       ///< [s]
  std::size_t restarts = 0;  ///< see Trial::restarts
  std::vector<RunWarning> warnings;
};

struct AnswerInput {
  std::string robot;
  std::vector<RunNotes> runs;
  std::string nextMotion;
  std::vector<std::string> remarks = {};
  ServoSettings settings = {};
};

/// A cause with its value, as answers list it.
nlohmann::json causeJson(const Cause& cause);

/// The answer as JSON text: the fields of doc/reference/gap-answer.md and further ones for the report. Sets
/// the evaluator's base to the explanation.
std::string answerJson(const AnswerInput& input, const Diagnosis& diagnosis, Evaluator& evaluator);

/// The verdict in a sentence or two, for people.
std::string verdictSentence(const Diagnosis& diagnosis);

/// A motion that exposes what the answer leaves open, in words.
std::string suggestion(const Diagnosis& diagnosis, const Evidence& evidence);

}  // namespace plumbline::gap
