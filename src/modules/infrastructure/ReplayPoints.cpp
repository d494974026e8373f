#include "modules/infrastructure/ReplayPoints.h"

#include <functional>

#include "framework/DebugSite.h"

namespace plumbline {
namespace {

struct Span {
  double first = 0, last = 0;
  std::uint64_t cycles = 0;
  void stream(InStream* in, OutStream* out) {
    STREAM(first);
    STREAM(last);
    STREAM(cycles);
  }
};

template <typename T>
class ControlValue final : public DebugValue {
public:
  ControlValue(T value, std::function<void(T)> set) : value_(value), set_(std::move(set)) {}
  void write(OutStream& out) const override { StreamType<T>::write(out, value_); }
  bool writable() const override { return true; }
  void read(InStream& in) override {
    T wanted = value_;
    StreamType<T>::read(in, wanted);
    if (!in.ok()) return;
    if constexpr (std::is_arithmetic_v<T>) {
      if (wanted < T{}) return in.fail("must not be negative");
    }
    set_(wanted);
  }

private:
  T value_;
  std::function<void(T)> set_;
};

template <typename T>
void passValue(DebugPoint& point, T value, std::function<void(T)> set) {
  if (!point.active()) return;
  ControlValue<T> control(value, std::move(set));
  point.pass(control);
}

template <typename F>
void passCode(DebugPoint& point, F&& code) {
  if (!point.active()) return;
  const DebugPoint::Visit visit(point);
  if (visit.run()) visit.output(code());
}

}  // namespace

ReplayPoints::ReplayPoints(AgentDebug& agent, record::ReplayControl& control)
    : agent_(agent), control_(control) {
  for (DebugPoint* point : {&cycle_, &time_, &speed_, &paused_, &step_, &back_, &span_})
    agent_.points.add(*point);
}

ReplayPoints::~ReplayPoints() {
  for (DebugPoint* point : {&cycle_, &time_, &speed_, &paused_, &step_, &back_, &span_})
    agent_.points.remove(*point);
}

void ReplayPoints::pass() {
  passValue<std::uint64_t>(cycle_, control_.position(),
                           [this](std::uint64_t cycle) { control_.goTo(static_cast<std::size_t>(cycle)); });
  passValue<double>(time_, control_.time(), [this](double time) { control_.goToTime(time); });
  passValue<double>(speed_, control_.speed(), [this](double speed) { control_.setSpeed(speed); });
  passValue<bool>(paused_, control_.paused(), [this](bool paused) { control_.pause(paused); });
  if (span_.active())
    debugging::output(span_, Span{control_.span().first, control_.span().second, control_.cycles()});
  const auto step = [this](long cycles) {
    control_.step(cycles);
    return std::string(cycles > 0 ? "a cycle on"
                                  : "one cycle back: everything restarts and is played up to there");
  };
  passCode(step_, [&] { return step(1); });
  passCode(back_, [&] { return step(-1); });
}

}  // namespace plumbline
