#pragma once
#include <string>
#include <vector>

#include "gap/inference/PerJointFit.h"

namespace plumbline::bench {

/// What a peer's way of fitting came to.
struct PeerFit {
  std::string name, what;  ///< in words
  gap::Explanation causes;
  std::size_t parameters = 0;
  double closedFitting =
      0;  ///< 1 - root of the squares left on the recordings fitted, over the nominal model's
  double cpuSeconds = 0;
};

/// Other ways of fitting, to the positions of the same segments of the same recordings. Each joint has its
/// own values.
class Peers {
public:
  Peers(const Mechanism& robot, std::vector<gap::Trial> segments, int jobs);

  /// "single", "mujoco-gauss-newton", "pace-cma-es", "everything-gauss-newton", "everything-cma-es", "bam-m1"
  /// to "bam-m6".
  std::vector<std::string> names() const;
  PeerFit fit(const std::string& name) const;

private:
  using Ids = std::vector<std::string_view>;
  /// From the nominal model or a smaller one, and from random values; the best on the recordings fitted.
  PeerFit byGaussNewton(const Ids& ids, const gap::Explanation& before) const;
  PeerFit byCmaes(const Ids& ids) const;
  PeerFit single() const;

  const Mechanism& robot_;
  const gap::Groups groups_;
  const gap::Replayer replayer_;
};

}  // namespace plumbline::bench
