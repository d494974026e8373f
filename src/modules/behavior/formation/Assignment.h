#pragma once
#include <vector>

namespace plumbline {

/// Assigns workers to jobs at the least total cost: the Hungarian method (Kuhn 1955; shortest augmenting
/// paths, Jonker and Volgenant 1987). cost[i][j] of worker i for job j, finite, as many jobs as workers at
/// least. Returns the job of each worker. If several assignments are equally good, the result is always the
/// same.
std::vector<int> assign(const std::vector<std::vector<double>>& cost);

}  // namespace plumbline
