#pragma once
#include <ode/ode.h>

#include <cstddef>
#include <cstdlib>
#include <new>

#include "framework/ThreadObject.h"
#include "math/Types.h"

namespace plumbline::simulation::ode {

/// ODE for the whole process. ODE itself does not look at whether it was given memory.
class OdeProcess {
public:
  OdeProcess() {
    dSetAllocHandler([](std::size_t size) { return orBadAlloc(std::malloc(size)); });
    dSetReallocHandler([](void* old, std::size_t, std::size_t size) {
      return size == 0 ? std::realloc(old, size) : orBadAlloc(std::realloc(old, size));
    });
    dInitODE2(0);
  }

private:
  static void* orBadAlloc(void* memory) { return memory ? memory : throw std::bad_alloc(); }
};

/// ODE's resources for a thread.
class OdeThread {
public:
  OdeThread() {
    if (dAllocateODEDataForThread(dAllocateMaskAll) == 0) throw std::bad_alloc();
  }
  ~OdeThread() { dCleanupODEAllDataForThread(); }
  OdeThread(const OdeThread&) = delete;
  OdeThread& operator=(const OdeThread&) = delete;
};

/// Gets ODE ready for the calling thread; call before any other use of ODE, it is cheap from the second time
/// on. Collision needs memory of its own in every thread, whichever thread made the world.
inline void ensureThread() {
  static const OdeProcess process;
  static ThreadObject<OdeThread> threads;
  threads.get();
}

inline Vec3 toVec3(const dReal* v) { return {v[0], v[1], v[2]}; }

/// ODE's rotation, three rows of four.
inline Mat3 toMat3(const dReal* r) {
  Mat3 m;
  m << r[0], r[1], r[2], r[4], r[5], r[6], r[8], r[9], r[10];
  return m;
}

inline void fromMat3(const Mat3& m, dMatrix3 r) {
  for (int row = 0; row < 3; ++row) {
    for (int col = 0; col < 3; ++col) r[4 * row + col] = m(row, col);
    r[4 * row + 3] = 0;
  }
}

inline void setBodyPose(dBodyID body, const Pose3& pose) {
  dMatrix3 rotation;
  fromMat3(pose.linear(), rotation);
  dBodySetPosition(body, pose.translation().x(), pose.translation().y(), pose.translation().z());
  dBodySetRotation(body, rotation);
}

inline Pose3 bodyPose(dBodyID body) {
  Pose3 pose = Pose3::Identity();
  pose.linear() = toMat3(dBodyGetRotation(body));
  pose.translation() = toVec3(dBodyGetPosition(body));
  return pose;
}

}  // namespace plumbline::simulation::ode
