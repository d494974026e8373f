#pragma once
#include <string>
#include <vector>

#include "gap/blind/BlindCase.h"

namespace plumbline::bench {

/// Simpler ways to answer a case, each written as an answer of the contract's form, FOLDER/<way>/<case>.json.
struct BaselineWay {
  const char* id;
  const char* what;
  bool placeOnly;    ///< names no effect
  bool libraryOnly;  ///< asked only where the library has what is missing
};
constexpr BaselineWay baselineWays[] = {
    {"largest_rmse", "largest joint RMSE", true, false},
    {"fit_everything", "CMA-ES fit of everything, largest deviation", false, false},
    {"nested_friction", "nested friction models by validation error", false, false},
    {"best_bic", "best single effect by BIC", false, false},
    {"oracle", "oracle that knows the effect", false, true}};

/// All but the first, which are not there yet. `best_bic`: the one effect that fits best, by the Bayesian
/// information criterion, nothing left out; `oracle`: knows which effects there are, finds places and values.
void writeBaselines(const gap::BlindCase& c, const Mechanism& robot, const std::string& runs,
                    const std::string& folder, int jobs);

/// `largest_rmse`: the joint whose position the nominal model misses most, from the answer of a diagnosis,
/// which has the nominal residuals.
void writeLargestRmse(const gap::BlindCase& c, const std::string& answer, const std::string& folder);

}  // namespace plumbline::bench
