#pragma once
#include "framework/Drawing.h"
#include "walking/engine/WalkEngine.h"

namespace plumbline {

/// The walk state: soles (the ones that carry filled), the centre of mass and where it goes, as realised
/// (green) and as observed (white).
void drawWalk(Drawing& drawing, const walking::WalkEngine& engine);

/// Where the feet will stand: the step in progress and those of the walk that is aimed at, `count` in all.
void drawPlannedSteps(Drawing& drawing, const walking::WalkEngine& engine, int count);

}  // namespace plumbline
