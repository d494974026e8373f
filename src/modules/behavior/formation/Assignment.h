#pragma once
#include <vector>

namespace plumbline {

/// Who does what at the least total cost: the Hungarian method (Kuhn 1955; shortest augmenting paths, Jonker
/// and Volgenant 1987). cost[i][j] of worker i for job j, finite, as many jobs as workers at least. Returns
/// the job of each worker. Where several are equally good, the same one is taken every time.
std::vector<int> assign(const std::vector<std::vector<double>>& cost);

}  // namespace plumbline
