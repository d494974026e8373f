#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "gap/diagnosis/Diagnosis.h"
#include "gap/diagnosis/ValueFit.h"

namespace plumbline::gap {

/// What could be added to the fine evaluator's base, from one look at all that is possible.
class Proposals {
public:
  /// coarse: with steps that do for a first look.
  Proposals(Evaluator& fine, Evaluator& coarse, const DiagnosisOptions& options)
      : fine_(fine), coarse_(coarse), options_(options) {}

  struct Look {
    std::string stage;               ///< as progress is told
    double leastGain = 0;            ///< of the sum of squares for fitting: what promises less is not fitted
    bool onlySensors = false;        ///< not what moves the robot
    bool lostCommands = true;        ///< cycles whose command was lost are looked for too
    SearchMemory* memory = nullptr;  ///< of looks at everything; null: none
  };
  /// Most probable first.
  std::vector<Candidate> find(const Look& look);
  /// Command dropout with the cycles that it is found in, where it says anything.
  void addLostCommands(std::vector<Candidate>& list);
  /// What screening on top of a base uses: coarse steps, unless these change the ranking, as they do for a
  /// motor that is just too weak for what it has to hold.
  const Evaluator& quickOn(const Explanation& base);

  /// Whose commands count as lost from now on, per trial and cycle.
  void useLostCycles(const std::vector<std::vector<std::uint8_t>>& cycles);

private:
  void priceLimitCycles(std::vector<Candidate>& list) const;

  Evaluator &fine_, &coarse_;
  const DiagnosisOptions& options_;
};

}  // namespace plumbline::gap
