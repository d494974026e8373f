#pragma once
#include "gap/blind/BlindScore.h"

namespace plumbline::gap {

/// Judges one case and its answer. Only the verdict `effect` names something. An effect is found if id, place
/// and axis are right, or those of a cause that is alike (BlindEffect::alike); two joints of one motor are
/// one place.
class BlindJudge {
public:
  explicit BlindJudge(const Mechanism& robot) : robot_(robot) {}

  bool same(const BlindEffect& truth, const NamedCause& named) const;
  /// The effect is among those named, not counting rivals.
  bool named(const BlindEffect& truth, const BlindAnswer& a) const;
  /// The strongest effect named is the case's first one.
  bool first(const BlindCase& c, const BlindAnswer& a) const;
  bool placeFirst(const BlindCase& c, const BlindAnswer& a) const;
  /// The strongest effect named, then its rivals and the other effects by probability, each cause once: among
  /// the first three.
  bool amongThree(const BlindCase& c, const BlindAnswer& a) const;
  /// How many of the case's effects are named, each by a different effect of the answer.
  std::size_t both(const BlindCase& c, const BlindAnswer& a) const;
  /// 2 |both| / (|named| + |true|).
  double setF1(const BlindCase& c, const BlindAnswer& a) const;
  /// The right verdict with the right set: none, unknown, the single first, or all of a mixture and no more.
  bool right(const BlindCase& c, const BlindAnswer& a) const;

private:
  bool sameName(const NamedPlace& truth, const NamedCause& named) const;

  const Mechanism& robot_;
};

}  // namespace plumbline::gap
