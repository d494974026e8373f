#pragma once
#include "framework/AgentDebug.h"
#include "framework/DebugPoint.h"
#include "record/ReplayControl.h"

namespace plumbline {

/// A replay in the debug interface. `replay:cycle`, `replay:time`, `replay:speed` and `replay:paused` can be
/// read and set. `replay:span` gives the first and the last time and the number of cycles. `dr replay:step`
/// and `dr replay:back` go one cycle forward or back.
class ReplayPoints {
public:
  ReplayPoints(AgentDebug& agent, record::ReplayControl& control);
  ~ReplayPoints();
  ReplayPoints(const ReplayPoints&) = delete;
  ReplayPoints& operator=(const ReplayPoints&) = delete;

  /// Call repeatedly on the thread that replays.
  void pass();

private:
  AgentDebug& agent_;
  record::ReplayControl& control_;
  DebugPoint cycle_{"replay:cycle", DebugKind::parameter}, time_{"replay:time", DebugKind::parameter},
      speed_{"replay:speed", DebugKind::parameter}, paused_{"replay:paused", DebugKind::parameter},
      step_{"replay:step", DebugKind::codeOnce}, back_{"replay:back", DebugKind::codeOnce},
      span_{"replay:span", DebugKind::output};
};

}  // namespace plumbline
