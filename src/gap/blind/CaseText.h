#pragma once
#include <string>

#include "gap/blind/BlindScore.h"

namespace plumbline::gap {

/// For a person: an effect at its place with its value.
std::string nameOfOne(const std::string& effect, const std::string& at, const std::string& axis,
                      double value);
/// What a case hides; "nothing" where it has no effect.
std::string hidden(const BlindCase& c);
/// What an answer names, each cause with its probability; else its verdict. withRivals: also what is easily
/// confused with each cause, and the nearest explanation of an unknown case.
std::string said(const BlindAnswer& a, bool withRivals);

/// A paragraph for each case that was answered wrongly, all: or rightly: what it hides and what was said. An
/// answer is right as BlindJudge::right has it.
std::string caseList(const BlindSet& set, const std::vector<BlindAnswer>& answers, const Mechanism& robot,
                     bool all);

}  // namespace plumbline::gap
