// The model and the world of bench/mujoco, which is a program of its own, serve this one as well.
#include "bench/mujoco/ModelText.cpp"  // NOLINT(bugprone-suspicious-include)
#include "bench/mujoco/World.cpp"      // NOLINT(bugprone-suspicious-include)
