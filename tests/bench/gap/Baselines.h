#pragma once
#include <string>

#include "gap/blind/BlindCase.h"

namespace plumbline::bench {

/// Simpler ways to answer a case, each written as an answer of the contract's form, FOLDER/<way>/<case>.json:
/// `best_bic`: the one effect that fits best, by the Bayesian information criterion, nothing held out;
/// `oracle`: knows which effects there are (only for cases of the library), finds places and values.
void writeBaselines(const gap::BlindCase& c, const Mechanism& robot, const std::string& runs,
                    const std::string& folder, int jobs);

/// `largest_rmse`: the joint whose position the nominal model misses most, from the answer of a diagnosis,
/// which has the nominal residuals; it names no effect.
void writeLargestRmse(const gap::BlindCase& c, const std::string& answer, const std::string& folder);

}  // namespace plumbline::bench
