#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "gap/diagnosis/Evaluator.h"

namespace plumbline::gap {

/// Judges sets of causes across servo settings, or across motions: fitted to the runs under all settings but
/// one, by how well they predict the runs under that one, each in turn (cross-validation over groups). What
/// absorbs another cause under one gain, or in one motion, does not in another; blocks of the same runs do
/// not tell that.
class GroupedCrossValidation {
public:
  enum class Left { setting, motion };  ///< what is left out in turn

  /// Groups the runs with a held base by the gains they were recorded with, or by their motion (windows of
  /// one recording go together). accuracy: the steps of all replays.
  GroupedCrossValidation(const Mechanism& mechanism, const Evidence& evidence, int jobs,
                         const ReplayOptions& accuracy = {}, Left left = Left::setting);
  /// Whether there are several groups.
  bool possible() const { return folds_.size() > 1; }

  /// A set of causes as the settings left out in turn were predicted with.
  struct Tried {
    Explanation causes;                ///< values: means, in strength, of what was fitted
    std::vector<Explanation> perFold;  ///< what was fitted with each setting left out
    /// Of what was left out: root of its squares over the nominal ones', mean over settings.
    double error = 1;
  };
  Tried of(const Explanation& causes) const;
  /// The set, of these kinds, that predicts best: causes are added one at a time to several sets at once
  /// while that takes away at least a twentieth. Starts: each kind with its starting values.
  Tried best(const std::vector<Cause>& starts, std::size_t maxCauses,
             const std::function<void(double share)>& progress) const;
  /// The same causes, each in the variant of its law that predicts best; another than it has comes in where
  /// it takes away a twentieth of the error.
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

/// The set of two that predicts each motion better from the others: what stands for something else in all
/// motions seen does not in one that was not. The proposed one counts in its best variants, and is returned
/// in them, its values fitted until they stay. Where there is one motion or doubt, blocks for judging decide.
Explanation betterAcrossMotions(const Evaluator& evaluator, const Explanation& proposed,
                                const Explanation& old, int jobs);

}  // namespace plumbline::gap
