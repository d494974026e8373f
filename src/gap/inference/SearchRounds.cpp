#include "gap/inference/SearchRounds.h"

#include <utility>

#include "gap/inference/PossibleKinds.h"
#include "gap/inference/Unexplained.h"

namespace plumbline::gap {

namespace {

constexpr std::size_t mostRounds = 4;  // of decoding and search

}  // namespace

SearchRounds::SearchRounds(const Mechanism& robot, std::vector<Trial> trials, const InferenceOptions& options)
    : robot_(robot), options_(options) {
  rounds_.push_back(std::make_unique<SearchRound>(robot, Groups(std::move(trials)), options));
}

std::size_t SearchRounds::numAsked() const {
  std::size_t sum = 0;
  for (const auto& round : rounds_) sum += round->search.numAsked();
  return sum;
}

/// Whether the last round's causes leave no more than the noise.
bool SearchRounds::explained() const {
  const SearchStage& first = *last().search.stages().front();
  return worstOf(first.replayer, first.best().causes()).share() <= 1;
}

/// What is lost with these causes in place, over what asSent explains of commands that all came.
SearchRounds::Decoded SearchRounds::decodedWith(const Explanation& causes, const Explanation& asSent) const {
  Decoded decoded{decodeLostCommands(sent().trials(), last().groups, causes, options_.jobs), {}};
  if (!decoded.lost.any()) return decoded;
  const std::vector<Trial> known = withLost(sent().trials(), decoded.lost);
  decoded.predicted = predictionsOf(known, causes, options_.jobs);
  const Groups groups(known, decoded.predicted);
  decoded.lost.evidence = evidenceOf(decoded.lost, Replayer(robot_, groups, options_.jobs), causes, asSent,
                                     possibleKinds(groups, robot_).size());
  return decoded;
}

/// Begins another round if these causes show other lost commands than are known.
bool SearchRounds::decode(const Explanation& causes) {
  if (options_.progress) options_.progress("lost commands", 0);
  Decoded best = decodedWith(causes, causes);
  Explanation onTime = causes;
  std::erase_if(onTime, [](const Cause& cause) { return cause.effect->delaysCommands; });
  // A small delay explains what lost commands do on average, and hides the rest.
  if (onTime.size() < causes.size())
    if (Decoded other = decodedWith(onTime, causes); other.lost.evidence > best.lost.evidence)
      best = std::move(other);
  if (best.lost.evidence > 0) {
    if (best.lost.cycles == lost_.cycles) {
      lost_.evidence = best.lost.evidence;
      return false;
    }
    begin(std::move(best.lost), best.predicted);
    return true;
  }
  if (!lost_.any()) return false;
  begin({}, {});
  return true;
}

void SearchRounds::begin(CommandLosses lost, const std::vector<Prediction>& predicted) {
  Groups groups = lost.any() ? Groups(withLost(sent().trials(), lost), predicted) : sent();
  const std::string name = ", commands lost " + std::to_string(rounds_.size());
  // From round to round few of many lost commands change.
  StagedSearch* const alike = lost_.any() && lost.any() ? &rounds_.back()->search : nullptr;
  Explanation onFeet;
  if (lost.any()) onFeet.push_back(CommandLosses::cause(lost.share()));
  lost_ = std::move(lost);
  rounds_.push_back(
      std::make_unique<SearchRound>(robot_, std::move(groups), options_, predicted, onFeet, name, alike));
}

void SearchRounds::run(StoredParts& parts) {
  const bool mayLose = mayHaveLostCommands(sent());
  bool many = false;  // causes, more than are fitted set by set
  // A set of causes that is searched for first takes in what lost commands do.
  if (mayLose && !decode({}) && repeatsDiffer(sent())) {
    rounds_.back()->search.findFew(parts);
    many = !explained();
    decode(last().search.causes());
  }
  rounds_.back()->search.findFirst(parts, many);
  while (mayLose && rounds_.size() < mostRounds) {
    const Explanation causes = last().search.causes();
    // Without causes nothing was lost, as is known already. Nor is anything looked for where nothing is left.
    if (!lost_.any() && (causes.empty() || (explained() && !repeatsDiffer(sent())))) break;
    if (!decode(causes)) break;
    rounds_.back()->search.findFirst(parts, many);
  }
  rounds_.back()->search.finish(parts);
  if (lost_.any())
    measureRecovery(lost_, sent().trials(), last().groups, last().search.causes(), options_.jobs);
}

}  // namespace plumbline::gap
