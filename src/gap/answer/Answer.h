#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "gap/diagnosis/Diagnosis.h"
#include "gap/run/Run.h"

namespace plumbline::gap {

/// What an answer says of the runs it rests on.
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
};

/// The answer as JSON text: the contract's fields, and what a report shows beside
/// (doc/reference/gap-answer.md). Leaves the evaluator with the explanation as its base.
std::string answerJson(const AnswerInput& input, const Diagnosis& diagnosis, Evaluator& evaluator);

/// The verdict in a sentence or two, for people.
std::string verdictSentence(const Diagnosis& diagnosis);

/// A motion that exposes what the answer leaves open, in words.
std::string suggestion(const Diagnosis& diagnosis, const Evidence& evidence);

}  // namespace plumbline::gap
