#pragma once
#include <vector>

#include "gap/inference/Replayer.h"

namespace plumbline::gap {

/// Per cell: what one residual says, in parts of an independent one (1 / correlationTime).
using Shares = std::vector<double>;

/// Shares from what a hypothesis leaves. What is wrong with a joint's model is one process, however many
/// sensors see it: its efforts have no more independent samples than its position.
Shares sharesOf(const Groups& groups, const Residuals& residuals);

/// A cell's residuals; empty where it was not predicted.
std::vector<double> residualsOf(const Cell& cell, const Residuals& residuals);

/// Whether a cell is of a position.
bool isPosition(const Groups& groups, const Cell& cell);
/// Sum of the squares of those that are finite.
double squaresOf(const std::vector<double>& values);

/// Logarithm of the density of a cell's residuals, its own discrepancy's scale being the likeliest one.
double densityOf(const Cell& cell, const Residuals& residuals, double share);

/// Sum over the cells of each group; 0 for groups that are not wanted (empty: all are).
std::vector<double> densities(const Groups& groups, const Residuals& residuals, const Shares& shares,
                              const std::vector<char>& wantedGroups = {});

/// Sum of densities() of what a hypothesis leaves in the wanted groups.
double densityOn(const Replayer& replayer, const Shares& shares, const Explanation& causes,
                 const std::vector<char>& wantedGroups = {});

/// Flags of the trials that hold anything of the wanted groups.
std::vector<char> trialsOf(const Groups& groups, const std::vector<char>& wantedGroups);

}  // namespace plumbline::gap
