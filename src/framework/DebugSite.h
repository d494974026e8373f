#pragma once
#include <string>

#include "framework/DebugPoint.h"
#include "framework/StreamTypes.h"
#include "framework/Streamable.h"

// The debug interface in the code: values that can be looked at or set, and blocks that can be switched on,
// while the agent runs (doc/reference/debug-protocol.md). Usable in every function above the framework; an id
// is a string literal, `module:BallLocator:candidates`. Off, each costs one relaxed load. An id is known from
// the first time on that it is passed.
namespace plumbline {

template <typename T>
class DebugVariable final : public DebugValue {
public:
  explicit DebugVariable(const T& value) : value_(const_cast<T&>(value)) {}
  DebugVariable(T& value, bool writable) : value_(value), writable_(writable) {}
  void write(OutStream& out) const override { StreamType<T>::write(out, value_); }
  bool writable() const override { return writable_; }
  void read(InStream& in) override {
    if (writable_) StreamType<T>::read(in, value_);
  }

private:
  T& value_;
  bool writable_ = false;
};

namespace debugging {

template <typename T>
void output(DebugPoint& point, const T& value) {
  DebugVariable<T> variable(value);
  point.pass(variable);
}
inline void output(DebugPoint& point, const char* text) { output(point, std::string(text)); }

template <typename T>
void modify(DebugPoint& point, T& value) {
  DebugVariable<T> variable(value, true);
  point.pass(variable);
}

}  // namespace debugging
}  // namespace plumbline

#define PLUMBLINE_DEBUG_POINT(id, kind_, ...)                                                   \
  do {                                                                                          \
    static constinit ::plumbline::DebugPoint plumblinePoint{id, ::plumbline::DebugKind::kind_}; \
    if (plumblinePoint.active()) [[unlikely]] {                                                 \
      __VA_ARGS__;                                                                              \
    }                                                                                           \
  } while (false)

/// The variable can be read: `get id`, `watch id`.
#define OUTPUT(id, variable) \
  PLUMBLINE_DEBUG_POINT(id, output, ::plumbline::debugging::output(plumblinePoint, variable))
/// The same for an expression, which is only evaluated when somebody looks.
#define OUTPUT_BY_VALUE(id, ...) \
  PLUMBLINE_DEBUG_POINT(id, output, ::plumbline::debugging::output(plumblinePoint, (__VA_ARGS__)))
/// The variable can be read, and overwritten here: `set id value`, `setOnce id value`, `unset id`.
#define MODIFY(id, variable) \
  PLUMBLINE_DEBUG_POINT(id, modify, ::plumbline::debugging::modify(plumblinePoint, variable))
#define PLUMBLINE_RESPONSE(id, kind_, ...)                                               \
  PLUMBLINE_DEBUG_POINT(                                                                 \
      id, kind_, const ::plumbline::DebugPoint::Visit plumblineResponse(plumblinePoint); \
      if (plumblineResponse.run()) { __VA_ARGS__; })
/// DEBUG_RESPONSE(id, code): the code runs each time execution comes here from `dr id` until `dr id off`, or
/// once after `dr id once`.
#define DEBUG_RESPONSE(id, ...) PLUMBLINE_RESPONSE(id, code, __VA_ARGS__)
/// The code runs once after each `dr id`.
#define DEBUG_RESPONSE_ONCE(id, ...) PLUMBLINE_RESPONSE(id, codeOnce, __VA_ARGS__)
/// In the code of a response: a line for those who switched it on.
#define DEBUG_RESPONSE_OUTPUT(text) plumblineResponse.output(text)
