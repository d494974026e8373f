#pragma once
#include <span>
#include <type_traits>

#include "framework/Streamable.h"

namespace plumbline {

/// Variables every representation shall have are added here (and filled by a Plugin). Must stay plain data.
class PluginRepresentationBase {};

/// The common base of everything on the blackboard.
class Representation : public Streamable, public PluginRepresentationBase {
protected:
  ~Representation() = default;
};

/// The bytes of the members of a representation that owns no memory beyond them.
template <typename R>
auto memberBytes(R& value) {
  using Byte = std::conditional_t<std::is_const_v<R>, const char, char>;
  return std::span<Byte>(reinterpret_cast<Byte*>(&value) + sizeof(Representation),
                         sizeof(R) - sizeof(Representation));
}

/// What REPRESENTATION(R) puts below class R. Without a stream method of its own, R is streamed as the block
/// of memory its members fill; the loader refuses that for members that own memory.
template <typename R>
class RepresentationOf : public Representation {
public:
  void stream(InStream* in, OutStream* out) override {
    // A class whose members are destroyed without any work holds no string, vector or other owner.
    if constexpr (std::is_trivially_destructible_v<R>) {
      const std::span<char> members = memberBytes(static_cast<R&>(*this));
      if (out) out->writeRaw(members.data(), members.size());
      if (in) in->readRaw(members.data(), members.size());
    }
  }

protected:
  ~RepresentationOf() = default;
};

}  // namespace plumbline

/// REPRESENTATION_OF(KickMotionOutput, MotionOutput) before `class KickMotionOutput : public
/// KickMotionOutputBase`: one of the representations of a kind, which modules read by
/// REQUIRES_ALL(MotionOutput). The kind is a class that derives from Representation, with `static constexpr
/// const char* kindName()` and a stream method that each representation's calls.
#define REPRESENTATION_OF(Name, Kind)                                   \
  class Name;                                                           \
  class Name##Base : public Kind {                                      \
  public:                                                               \
    static constexpr const char* representationName() { return #Name; } \
                                                                        \
  protected:                                                            \
    using Kind::Kind;                                                   \
    ~Name##Base() = default;                                            \
  };

/// REPRESENTATION(BallPos) before `class BallPos : public BallPosBase { ... };`
#define REPRESENTATION(Name)                                            \
  class Name;                                                           \
  class Name##Base : public ::plumbline::RepresentationOf<Name> {       \
  public:                                                               \
    static constexpr const char* representationName() { return #Name; } \
                                                                        \
  protected:                                                            \
    ~Name##Base() = default;                                            \
  };
