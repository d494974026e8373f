#pragma once
#include <vector>

#include "gap/diagnosis/Explanation.h"
#include "gap/replay/Trial.h"
#include "gap/run/Run.h"

namespace plumbline::gap {

/// Recordings of a robot with its nominal model: what a diagnosis is given.
struct RealRecordings {
  Mechanism robot;
  std::vector<Run> runs;
  std::vector<Trial> trials;  ///< of the runs with the robot

  RealRecordings(Mechanism model, std::vector<Run> recordings);
};

/// Effects that can be planted in recordings (Effect::planting), in the order of their ranks.
std::vector<const Effect*> plantable();

/// Causes of an effect at all places of the robot that were recorded, each with one value per start of the
/// effect.
std::vector<Cause> plantsFor(const RealRecordings& base, const Effect& effect);
/// Those of all plantable() effects.
std::vector<Cause> plantsFor(const RealRecordings& base);

/// The recordings with the model that lacks the cause, of a plantable effect. Throws std::runtime_error if it
/// cannot.
RealRecordings planted(const RealRecordings& base, const Cause& cause);

/// Residuals of all positions after 0.3 s, one after the other [rad]; NaN where nothing was measured.
std::vector<double> residualsOf(const RealRecordings& base, const Explanation& causes);

/// How many of these residuals a position of a trial has.
std::size_t residualCycles(const Trial& trial);

std::vector<double> minus(std::vector<double> a, const std::vector<double>& b);

/// Cosine of the angle between two vectors over what is finite in both; 0 if one has no length.
double cosine(const std::vector<double>& a, const std::vector<double>& b);

/// Root mean square of a - b over what is finite in both [rad].
double differenceOf(const std::vector<double>& a, const std::vector<double>& b);

/// The cause with the value that moves the residuals of the nominal model by so much [rad], within 40 %; its
/// value is nominal where none does.
Cause sized(const RealRecordings& base, Cause cause, double change);

/// Least that a cause, whatever its value, leaves of what the plant changes, as a share of the change: near 0
/// for the planted one in another name.
double leftOfPlant(const RealRecordings& base, const RealRecordings& planted, const Cause& cause);

}  // namespace plumbline::gap
