#include "gap/inference/AllJointFit.h"

#include <algorithm>
#include <cstdio>

#include "gap/effects/Effects.h"
#include "gap/inference/CauseKinds.h"
#include "gap/inference/LeaveOut.h"
#include "gap/inference/LeaveOutBias.h"
#include "gap/inference/PerJointFit.h"
#include "gap/inference/StoredParts.h"

namespace plumbline::gap {

namespace {

constexpr int fitSteps = 8;
constexpr double leastClosed = 0.02;  // share of the gap that is worth a sentence
/// With a tenth of the squares left in some ten independent samples, standard deviations of 1.8 and 3.2 of
/// the least starts of a search: decision 17.
constexpr Shrinkage prior{.own = 3e-3, .common = 1e-3};

/// The kinds that identification fits in every joint, and those named; values start at those named.
PerJoint startAt(const Mechanism& robot, const Explanation& named) {
  std::vector<const Effect*> kinds = actuatorEffects();
  for (const Effect* kind : kindsAtJoints(named))
    if (std::ranges::find(kinds, kind) == kinds.end()) kinds.push_back(kind);
  PerJoint start = perJoint(robot, named, kinds);
  for (Cause& cause : start.causes)
    if (std::ranges::find(named, cause.effect, &Cause::effect) == named.end())
      cause.variant = cause.effect->perJointFit.variant;
  return start;
}

}  // namespace

std::string AllJointFit::sentence() const {
  if (closed <= leastClosed) return "";
  char text[160];
  std::snprintf(text, sizeof text,
                "A further %.0f %% closes by fitting %zu values of all joints at once; not attributable.",
                100 * closed, parameters);
  return text;
}

AllJointFit fitOfAllJoints(const Mechanism& robot, const std::vector<Trial>& trials, const Explanation& named,
                           const std::vector<Explanation>& namedWithout,
                           const std::vector<RecordingLeft>& leftOut, const InferenceOptions& options) {
  AllJointFit further;
  const Groups groups(trials);
  if (std::ranges::any_of(trials, &Trial::freeBase)) return further;
  const Replayer replayer(robot, groups, options.jobs,
                          hasFewKinds(groups, robot) ? ReplayOptions() : withLongSteps());
  StoredParts parts(options.memory, [&] { return replayer.numAsked(); });
  double fits = 0;
  const auto fitTo = [&](const std::string& name, const Groups& some, const PerJoint& start) {
    if (options.progress)
      options.progress("all values of all joints", fits++ / static_cast<double>(groups.count() + 1));
    return parts.values("all joints" + name,
                        [&] { return fitPerJoint(Replayer(replayer, some), start, fitSteps, prior).causes; });
  };
  std::vector<FoundWithout> found(groups.count());
  for (std::size_t g = 0; g < groups.count(); ++g)
    found[g].causes = fitTo(nameWithout(g), groups.without(g), startAt(robot, namedWithout.at(g)));
  const PerJoint start = startAt(robot, named);
  further.parameters = start.parameters;
  further.leftOut = leftWithout(groups, found);
  further.closed = meanClosed(further.leftOut) - meanClosed(leftOut);
  further.model = fitTo("", groups, start);
  further.claim = claimOf(closedPerGroup(further.leftOut, groupsOfRecordings(groups)),
                          leaveOutBias(groups, further.model, found));
  std::erase_if(further.model, [&](const Cause& cause) { return doesNothing(robot, cause); });
  return further;
}

}  // namespace plumbline::gap
