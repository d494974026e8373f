#include "walking/estimation/ClosedLoop.h"

namespace plumbline::walking {

void ClosedLoop::reset() {
  observer_.reset();
  underway_.clear();
  present_ = {};
  support_ = Support::both;
}

void ClosedLoop::pass(const WalkAction& action, double time) {
  if (present_.count == present_.segment.size()) return;
  Segment& segment = present_.segment[present_.count++];
  segment = {};
  segment.support = support_;
  segment.action = action;
  segment.time = time;
}

void ClosedLoop::land(const Pose2& T_support_swing, Support next) {
  support_ = next;
  if (present_.count == 0) return;
  Segment& segment = present_.segment[present_.count - 1];
  segment.lands = true;
  segment.landing = T_support_swing;
  segment.next = next;
}

void ClosedLoop::endCycle() {
  underway_.push_back(present_);
  present_ = {};
}

std::optional<WalkState> ClosedLoop::update(const WalkSensors& sensors, const WalkModel& model,
                                            std::size_t delay, double imuAverage) {
  while (underway_.size() > std::max<std::size_t>(1, delay)) underway_.pop_front();
  if (underway_.size() < std::max<std::size_t>(1, delay)) return std::nullopt;
  const Cycle& shown = underway_.front();
  const Segment last = shown.count > 0 ? shown.segment[shown.count - 1] : Segment{};
  const Support now = last.lands ? last.next : last.support;
  observer_.update(sensors, now, last.action, model, imuAverage);

  WalkState state = observer_.state();
  for (std::size_t i = 1; i < underway_.size(); ++i) {
    const Cycle& cycle = underway_[i];
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
