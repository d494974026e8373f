#include "gap/inference/Further.h"

#include <algorithm>
#include <cstdio>

#include "gap/inference/LeaveOut.h"
#include "gap/inference/PerJointFit.h"

namespace plumbline::gap {

namespace {

constexpr int fitSteps = 4;
constexpr double worthSaying = 0.02;

}  // namespace

std::string Further::sentence() const {
  if (closed <= worthSaying) return "";
  char text[160];
  std::snprintf(text, sizeof text,
                "A further %.0f %% closes by fitting all frictions per joint (%zu values); not attributable.",
                100 * closed, parameters);
  return text;
}

Further furtherOf(const Mechanism& robot, const std::vector<Trial>& trials,
                  const std::vector<Explanation>& foundElse, const std::vector<RecordingLeft>& leftOut,
                  int jobs) {
  Further further;
  const Groups groups(trials);
  if (std::ranges::any_of(trials, &Trial::freeBase) || foundElse.size() != groups.count()) return further;
  const Replayer replayer(robot, groups, jobs);
  std::vector<FoundWithout> found(groups.count());
  for (std::size_t g = 0; g < groups.count(); ++g) {
    const Groups others = groups.without(g);
    const PerJoint fitted =
        fitPerJoint(Replayer(replayer, others), perJoint(robot, foundElse[g], frictions()), fitSteps);
    further.parameters = fitted.parameters;
    found[g].causes = fitted.causes;
  }
  further.leftOut = leftWithout(groups, found);
  further.closed = meanClosed(further.leftOut) - meanClosed(leftOut);
  return further;
}

}  // namespace plumbline::gap
