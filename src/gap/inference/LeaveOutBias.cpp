#include "gap/inference/LeaveOutBias.h"

#include "gap/inference/Claim.h"

namespace plumbline::gap {

namespace {

double meanLogLeft(const std::vector<RecordingLeft>& left, const std::vector<std::size_t>& groupOfRecording) {
  const std::vector<double> closed = closedPerGroup(left, groupOfRecording);
  double sum = 0;
  for (const double of : closed) sum += logLeft(of);
  return closed.empty() ? 0 : sum / static_cast<double>(closed.size());
}

}  // namespace

double leaveOutBias(const Groups& groups, const Explanation& answer,
                    const std::vector<FoundWithout>& without) {
  if (without.empty()) return 0;
  std::vector<Explanation> sets{answer};
  for (const FoundWithout& found : without) sets.push_back(found.causes);
  const std::vector<std::vector<RecordingLeft>> left = leftWithEach(groups, sets);
  const std::vector<std::size_t> of = groupsOfRecordings(groups);
  double sum = 0;
  for (std::size_t i = 1; i < left.size(); ++i) sum += meanLogLeft(left[i], of);
  return meanLogLeft(left.front(), of) - sum / static_cast<double>(without.size());
}

}  // namespace plumbline::gap
