#pragma once
#include <string>
#include <vector>

#include "gap/diagnosis/Explanation.h"
#include "gap/replay/Trial.h"

namespace plumbline::bench {

/// Recordings of a robot with its nominal model: what a diagnosis is given.
struct Base {
  Mechanism robot;
  std::vector<gap::Trial> trials;
};

/// Causes that can be planted exactly: by removing a cause from the nominal model (a gain of 1.3 in reality
/// is one divided by 1.3 in the model), or by changing the data, if that is equivalent. Per cause one value,
/// of 1 deviation from nominal in its starts; the recordings stay real.
std::vector<gap::Cause> plantsFor(const Base& base);

/// The recordings with the model that lacks the cause. Throws std::runtime_error where it cannot.
Base planted(const Base& base, const gap::Cause& cause);

/// Residuals of all positions after 0.3 s, one after the other [rad]; NaN where nothing was measured.
std::vector<double> residualsOf(const Base& base, const gap::Explanation& causes);

/// Root mean square of a - b over what is finite in both [rad].
double differenceOf(const std::vector<double>& a, const std::vector<double>& b);

/// The cause with the value that moves the residuals of the nominal model by so much [rad], within a few per
/// cent; its value is nominal where none does.
gap::Cause sized(const Base& base, gap::Cause cause, double change);

/// Least that a cause, whatever its value, leaves of what the plant changes, as a share of the change: near 0
/// for the planted one in another name.
double leftOfPlant(const Base& base, const Base& planted, gap::Cause cause);

}  // namespace plumbline::bench
