#pragma once
#include "ChainReplay.h"

namespace plumbline::bench {

/// Nested friction models at the joint with the largest gap: none, Coulomb, then also viscous, Stribeck, and
/// friction that grows with load. Duclusaud et al., "Extended Friction Models for the Physics Simulation of
/// Servo Actuators", 2024, choose the last one for a servo. Each is fitted by CMA-ES; the one with the least
/// error on the blocks for judging is taken, and named after the term without which that error rises most.
/// Empty where no friction judges best.
gap::Explanation nestedFriction(const Mechanism& robot, const ChainReplay& chain, int jobs);

}  // namespace plumbline::bench
