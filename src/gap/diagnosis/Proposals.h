#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "gap/diagnosis/Diagnosis.h"
#include "gap/diagnosis/ValueFit.h"

namespace plumbline::gap {

/// Candidates for the next cause on top of the fine evaluator's base, from a screening of all possible
/// causes.
class Proposals {
public:
  /// coarse: with longer steps for screening.
  Proposals(Evaluator& fine, Evaluator& coarse, const DiagnosisOptions& options)
      : fine_(fine), coarse_(coarse), options_(options) {}

  struct Look {
    std::string stage;         ///< its name in progress messages
    double leastGain = 0;      ///< of the sum of squares for fitting: causes that promise less are not fitted
    bool onlySensors = false;  ///< no cause that moves the robot
    bool lostCommands = true;  ///< also searches for lost commands
    SearchMemory* memory = nullptr;  ///< of screenings; null: none
  };
  /// Most probable first.
  std::vector<FittedCause> find(const Look& look);
  /// Adds command dropout with the lost cycles found, if there are any.
  void addLostCommands(std::vector<FittedCause>& list);
  /// The evaluator for screening on top of a base: coarse steps, unless these change the ranking, as for a
  /// motor that is just too weak for its load.
  const Evaluator& quickOn(const Explanation& base);

  /// Sets the lost commands, per trial and cycle.
  void useLostCycles(const std::vector<std::vector<std::uint8_t>>& cycles);

private:
  void priceLimitCycles(std::vector<FittedCause>& list) const;

  Evaluator &fine_, &coarse_;
  const DiagnosisOptions& options_;
};

}  // namespace plumbline::gap
