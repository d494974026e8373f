#include "gap/inference/LeaveOutBias.h"

#include "gap/inference/Claim.h"

namespace plumbline::gap {

namespace {

double meanLogLeft(const Groups& groups, const Explanation& causes) {
  const std::vector<double> closed = closedPerGroup(leftWith(groups, causes), groupsOfRecordings(groups));
  double sum = 0;
  for (const double of : closed) sum += logLeft(of);
  return closed.empty() ? 0 : sum / static_cast<double>(closed.size());
}

}  // namespace

double leaveOutBias(const Groups& groups, const Explanation& answer,
                    const std::vector<FoundWithout>& without) {
  if (without.empty()) return 0;
  double sum = 0;
  for (const FoundWithout& found : without) sum += meanLogLeft(groups, found.causes);
  return meanLogLeft(groups, answer) - sum / static_cast<double>(without.size());
}

}  // namespace plumbline::gap
