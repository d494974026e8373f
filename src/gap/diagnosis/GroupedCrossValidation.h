#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// Judges sets of causes by cross-validation over groups of runs: servo settings or motions. A set is fitted
/// to all groups except one and judged by its prediction for that one, each in turn. A cause that imitates
/// another under one gain, or in one motion, does not under another; blocks of the same runs would not show
/// that.
class GroupedCrossValidation {
public:
  enum class Left { setting, motion };  ///< what is left out in turn

  /// Groups the runs with a fixed base by the gains they were recorded with, or by their motion (segments of
  /// one recording go together). accuracy: the steps of all replays.
  GroupedCrossValidation(const Mechanism& mechanism, const Evidence& evidence, int jobs,
                         const ReplayOptions& accuracy = {}, Left left = Left::setting);
  /// Whether there are several groups.
  bool possible() const { return folds_.size() > 1; }

  /// A set of causes and its error on the groups left out.
  struct Tried {
    Explanation causes;                ///< values: means, in strength, of what was fitted
    std::vector<Explanation> perFold;  ///< what was fitted with each setting left out
    /// Error on the groups left out: root of the squares divided by the nominal ones, mean over groups.
    double error = 1;
  };
  Tried of(const Explanation& causes) const;
  /// The set of these kinds that predicts best. Causes are added one at a time to several sets at once while
  /// that removes at least a twentieth of the error. Starts: each kind with its starting values.
  Tried best(const std::vector<Cause>& starts, std::size_t maxCauses,
             const std::function<void(double share)>& progress) const;
  /// The same causes, each in the variant of its law that predicts best. A variant is changed only if that
  /// removes a twentieth of the error.
  Tried withBestVariants(Tried best) const;

private:
  struct Fold {
    Evidence fitted, left;
    Evaluator fit, judge;
    double nominal = 0;  ///< squares left out, under the nominal model
    Fold(const Mechanism& mechanism, std::vector<Trial> fitted, std::vector<Trial> left,
         const ReplayOptions& accuracy);
  };
  double squaresLeft(const Fold& fold, const Explanation& causes) const;
  Tried fitted(const Tried& from) const;
  Tried refined(Tried tried) const;
  Tried withKind(const Tried& from, const std::vector<Cause>& starts) const;

  const Mechanism& robot_;
  int jobs_;
  std::vector<std::unique_ptr<Fold>> folds_;
};

/// Of two sets, the one that predicts each motion better from the others: a cause that imitates another in
/// all fitted motions does not in a new one. The proposed set is judged and returned with its best variants,
/// its values fitted until they converge. With a single motion or an unclear result, the blocks for judging
/// decide.
Explanation betterAcrossMotions(const Evaluator& evaluator, const Explanation& proposed,
                                const Explanation& old, int jobs);

}  // namespace plumbline::gap
