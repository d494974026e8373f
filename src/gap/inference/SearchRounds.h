#pragma once
#include <memory>
#include <string>
#include <vector>

#include "gap/inference/CommandLosses.h"
#include "gap/inference/StagedSearch.h"

namespace plumbline::gap {

/// A search for sets of causes with what is known of lost commands. Not copied: its members refer to each
/// other.
struct SearchRound {
  /// predicted: of the groups. onFeet: what recordings on the feet have with every hypothesis. alike: see
  /// StagedSearch.
  SearchRound(const Mechanism& robot, Groups judging, const InferenceOptions& options,
              const std::vector<Prediction>& predicted = {}, const Explanation& onFeet = {},
              const std::string& name = "", StagedSearch* alike = nullptr)
      : groups(std::move(judging)),
        replayer(robot, groups, options.jobs, {}, onFeet),
        search(replayer, options, predicted, name, alike) {}
  SearchRound(const SearchRound&) = delete;
  SearchRound& operator=(const SearchRound&) = delete;

  const Groups groups;
  const Replayer replayer;
  StagedSearch search;
};

/// Decodes lost commands and searches for sets of causes in turn, until the same commands are lost again
/// (doc/decisions/0022). Where none can have been lost, or none are found, it is one search.
class SearchRounds {
public:
  SearchRounds(const Mechanism& robot, std::vector<Trial> trials, const InferenceOptions& options);

  void run(StoredParts& parts);

  /// Of the recordings as their commands were sent.
  const Groups& sent() const { return rounds_.front()->groups; }
  const SearchRound& last() const { return *rounds_.back(); }
  const CommandLosses& lost() const { return lost_; }
  std::size_t numAsked() const;  ///< see Replayer

private:
  bool explained() const;
  struct Decoded {
    CommandLosses lost;
    std::vector<Prediction> predicted;  ///< with these losses; empty if there are none
  };
  Decoded decodedWith(const Explanation& causes, const Explanation& asSent) const;
  bool decode(const Explanation& causes);
  void begin(CommandLosses lost, const std::vector<Prediction>& predicted);

  const Mechanism& robot_;
  const InferenceOptions& options_;
  std::vector<std::unique_ptr<SearchRound>> rounds_;
  CommandLosses lost_;
};

}  // namespace plumbline::gap
