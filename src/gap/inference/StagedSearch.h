#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gap/inference/CandidateScreening.h"
#include "gap/inference/Inference.h"
#include "gap/inference/LeaveOut.h"
#include "gap/inference/StoredParts.h"
#include "gap/inference/WindowReplayer.h"

namespace plumbline::gap {

/// One search of a diagnosis with what it came to. Not copied: its replayer refers to its groups.
struct SearchStage {
  SearchStage(const Mechanism& robot, Groups judging, int jobs)
      : groups(std::move(judging)), replayer(robot, groups, jobs) {}
  /// groups: of the same trials as those of the other replayer. base: causes found before.
  SearchStage(const Replayer& sameTrials, Groups judging, Explanation base = {})
      : groups(std::move(judging)), replayer(sameTrials, groups, std::move(base)) {}
  SearchStage(const SearchStage&) = delete;
  SearchStage& operator=(const SearchStage&) = delete;

  const Groups groups;  ///< that judge the sets
  const Replayer replayer;
  BeamResult found;
  std::vector<double> probabilities;  ///< of the sets found
  std::vector<FoundWithout> without;  ///< per group

  const Scored& best() const { return found.sets.front(); }
};

/// Searches for sets of causes, in two stages where some recordings have a fixed base and others a free one
/// (doc/decisions/0021). The first stage looks in those with a fixed base alone. The second looks in all,
/// with the causes found in place and their values held, for kinds that the first do not rule out (RuledOut).
class StagedSearch {
public:
  /// whole: of all recordings; must outlive it. Recordings on the feet have its base (Replayer). predicted:
  /// of its groups. name: what the names of stored parts end with. alike: of the same trials with nearly the
  /// same commands, whose screening serves this one as well; null: none.
  StagedSearch(const Replayer& whole, const InferenceOptions& options,
               const std::vector<Prediction>& predicted = {}, std::string name = "",
               StagedSearch* alike = nullptr);

  /// The first stage's sets. expectMany: see SetSearchOptions.
  void findFirst(StoredParts& parts, bool expectMany);
  /// The same, quickly: sets of few causes.
  void findFew(StoredParts& parts);
  /// After that: what is found without each group, and the second stage.
  void finish(StoredParts& parts);

  const std::vector<std::unique_ptr<SearchStage>>& stages() const { return stages_; }
  /// Of all stages.
  Explanation causes() const;
  /// Per group of all recordings: the causes of all stages, found without it.
  std::vector<FoundWithout> withoutEach() const;
  /// With long steps, of a robot with many kinds of causes and a fixed base; else null.
  const Replayer* coarse() const { return coarse_ ? &*coarse_ : nullptr; }
  /// See Replayer; with those of the whole.
  std::size_t numAsked() const;

private:
  std::size_t mostCauses() const;  ///< in the answer
  void find(const std::string& part, StoredParts& parts);
  BeamResult searchAllKinds(const std::string& part, std::size_t groups, StoredParts& parts,
                            const std::function<BeamResult()>& run);
  SearchTools tools();
  const CandidateScreening& screening(StoredParts& parts);
  void searchKindsLeft(SearchStage& stage, StoredParts& parts);
  void report(const char* what, double share) const {
    if (options_.progress) options_.progress(what, share);
  }

  const Replayer& whole_;
  const InferenceOptions& options_;
  bool twoStages_ = false, few_ = false;
  std::vector<std::unique_ptr<SearchStage>> stages_;
  std::optional<WindowReplayer> windows_;  ///< of the first stage
  std::optional<Replayer> coarse_;
  const std::string name_;
  StagedSearch* const alike_;
  SetSearchOptions search_;  ///< of the first stage
  /// Serves all searches of the first stage, but takes long: where all are stored, nobody needs it.
  std::optional<CandidateScreening> screening_;
};

}  // namespace plumbline::gap
