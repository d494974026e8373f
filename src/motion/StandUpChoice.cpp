#include "motion/StandUpChoice.h"

#include <cmath>
#include <utility>

namespace plumbline::motion {

namespace {

const std::string& usualFrom(const StandUpParameters& parameters, LyingOn how) {
  switch (how) {
    case LyingOn::front:
      return parameters.front;
    case LyingOn::back:
      return parameters.back;
    default:
      return parameters.side;
  }
}

}  // namespace

std::optional<MissingStandUp> missingStandUp(const StandUpParameters& parameters,
                                             const std::vector<KeyframeMotion>& motions) {
  for (const auto& [parameter, name] : {std::pair{"front", &parameters.front},
                                        {"back", &parameters.back},
                                        {"side", &parameters.side},
                                        {"fastFront", &parameters.fastFront},
                                        {"fastBack", &parameters.fastBack}})
    if (!name->empty() && !findMotion(motions, *name))
      return MissingStandUp{parameter, missingMotion(motions, *name)};
  return std::nullopt;
}

bool standsUpFrom(const StandUpParameters& parameters, LyingOn how) {
  return !usualFrom(parameters, how).empty();
}

LyingOn lyingOn(const Vec3& up) {
  if (std::abs(up.x()) < std::abs(up.y())) return LyingOn::side;
  return up.x() < 0 ? LyingOn::front : LyingOn::back;
}

void StandUpChoice::learn(const StandUpParameters& parameters, const std::vector<KeyframeMotion>& motions) {
  fastFront_ = findMotion(motions, parameters.fastFront);
  fastBack_ = findMotion(motions, parameters.fastBack);
}

const std::string& StandUpChoice::next(const StandUpParameters& parameters, LyingOn how, bool again) {
  // The motion after a roll belongs to the same try.
  if (!again)
    failed_ = 0;
  else if (!rolled_)
    ++failed_;
  rolled_ = how == LyingOn::side;
  const bool first = failed_ % 2 == 0;
  if (first && how == LyingOn::front && fastFront_) return parameters.fastFront;
  if (first && how == LyingOn::back && fastBack_) return parameters.fastBack;
  return usualFrom(parameters, how);
}

void StandUpChoice::forget() {
  rolled_ = false;
  failed_ = 0;
}

}  // namespace plumbline::motion
