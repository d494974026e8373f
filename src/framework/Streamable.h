#pragma once
#include "framework/InStream.h"
#include "framework/OutStream.h"
#include "framework/StreamTypes.h"

namespace plumbline {

/// A class that writes and reads itself through one method, a STREAM line per member:
///
///     void stream(InStream* in, OutStream* out) override {
///       STREAM(relative);
///       STREAM("label", other);
///     }
///
/// With `out` the members are written, with `in` they are read; whichever is null is left alone.
class Streamable {
public:
  virtual void stream(InStream* in, OutStream* out) = 0;

protected:
  // Not virtual on purpose: a class of plain members stays trivially destructible, and nothing is deleted
  // through this base.
  ~Streamable() = default;
  Streamable() = default;
  Streamable(const Streamable&) = default;
  Streamable& operator=(const Streamable&) = default;
};

/// One labelled member, written and/or read. What STREAM expands to.
template <typename T>
void streamMember(InStream* in, OutStream* out, std::string_view label, T& member) {
  if (out) {
    if (!out->check()) out->label(label);
    StreamType<T>::write(*out, member);
  }
  if (in) {
    in->label(label);
    if (in->ok()) StreamType<T>::read(*in, member);
  }
}

}  // namespace plumbline

#define PLUMBLINE_STREAM_ONE(member) ::plumbline::streamMember(in, out, #member, member)
#define PLUMBLINE_STREAM_TWO(label, member) ::plumbline::streamMember(in, out, label, member)
#define PLUMBLINE_STREAM_PICK(first, second, macro, ...) macro
/// STREAM(member) or STREAM("label", member), inside stream(InStream* in, OutStream* out).
#define STREAM(...) \
  PLUMBLINE_STREAM_PICK(__VA_ARGS__, PLUMBLINE_STREAM_TWO, PLUMBLINE_STREAM_ONE, )(__VA_ARGS__)
