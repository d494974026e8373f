#include "walking/estimation/ClosedLoop.h"

namespace plumbline::walking {

void ClosedLoop::reset() {
  observer.reset();
  underway.clear();
  present = {};
  support = Support::both;
}

void ClosedLoop::pass(const WalkAction& action, double time) {
  if (present.count == present.segment.size()) return;
  Segment& segment = present.segment[present.count++];
  segment = {};
  segment.support = support;
  segment.action = action;
  segment.time = time;
}

void ClosedLoop::land(const Pose2& T_support_swing, Support next) {
  support = next;
  if (present.count == 0) return;
  Segment& segment = present.segment[present.count - 1];
  segment.lands = true;
  segment.landing = T_support_swing;
  segment.next = next;
}

void ClosedLoop::endCycle() {
  underway.push_back(present);
  present = {};
}

std::optional<WalkState> ClosedLoop::update(const WalkSensors& sensors, const WalkModel& model,
                                            std::size_t delay, double imuAverage) {
  while (underway.size() > std::max<std::size_t>(1, delay)) underway.pop_front();
  if (underway.size() < std::max<std::size_t>(1, delay)) return std::nullopt;
  const Cycle& shown = underway.front();
  const Segment last = shown.count > 0 ? shown.segment[shown.count - 1] : Segment{};
  const Support now = last.lands ? last.next : last.support;
  observer.update(sensors, now, last.action, model, imuAverage);

  WalkState state = observer.state();
  for (std::size_t i = 1; i < underway.size(); ++i) {
    const Cycle& cycle = underway[i];
    for (std::size_t j = 0; j < cycle.count; ++j) {
      const Segment& segment = cycle.segment[j];
      state.support = segment.support;
      state = model.move(state, segment.action, segment.time);
      if (!segment.lands) continue;
      const Side from = state.supportSide();
      if (segment.support != Support::both)
        state.foot[index(other(from))] = state.foot[index(from)] * segment.landing;
      state.support = segment.next;
    }
  }
  return state;
}

}  // namespace plumbline::walking
