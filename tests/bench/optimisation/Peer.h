#pragma once
#include <Eigen/Core>
#include <ctime>
#include <string>

namespace plumbline::bench {

/// Standard deviation of the first candidates around the start, ours and pagmo's. Rastrigin's minima are 1
/// apart: from 0.5 no search with this population leaves the one it begins in; 2 is that of Hansen and Kern
/// (PPSN 2004).
constexpr double firstDeviation = 0.5, rastriginDeviation = 2;

/// Time that this process has computed [s], which says the same on a busy machine.
inline double processorSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

using Function = double (*)(const Eigen::VectorXd&);

/// A run of pagmo's cmaes or xnes from the same place with the same first deviation (both as ours).
struct PeerRun {
  double evaluations = 0, best = 0;
  double firstBest = 0;  ///< best cost of the first generation that it draws, or of the start if that is less
  double seconds = 0;    ///< of the whole run, on the processor
  double generations = 0;
};

/// Generations run in blocks of about a fiftieth of the work, because pagmo stops at a given generation and
/// not at a cost. The result is the first generation with a best of at most `target`, from its log.
PeerRun runPeer(const std::string& algorithm, Function function, int dimension, double start, int population,
                double target, double maxEvaluations, unsigned seed, double deviation = firstDeviation);

}  // namespace plumbline::bench
