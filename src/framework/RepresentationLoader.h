#pragma once
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <type_traits>

#include "framework/Representation.h"

namespace plumbline {

/// Owns one representation whose type only its loader knows.
class RepresentationHolder {
public:
  virtual ~RepresentationHolder() = default;
  virtual Representation& get() = 0;
};

/// What the framework knows of a type of representation: its name, how to make one, how to copy one, and what
/// a value of it must not be.
class RepresentationLoader {
public:
  virtual ~RepresentationLoader() = default;
  virtual const std::string& name() const = 0;
  /// The kind of REPRESENTATION_OF, or empty.
  virtual const std::string& kind() const = 0;
  virtual std::unique_ptr<RepresentationHolder> create() const = 0;
  /// `to` = `from`; both must be of the loader's type.
  virtual void copy(const Representation& from, Representation& to) const = 0;
  /// The bytes of a value that owns no memory beyond them; nothing for others.
  virtual std::optional<std::span<const char>> plainBytes(const Representation& value) const = 0;
  /// "", or in one line what the representation's own check says: `std::string problem() const`, where it has
  /// one.
  virtual std::string ownProblem(const Representation& value) const = 0;
  virtual bool hasOwnCheck() const = 0;
  /// "", or what is wrong with a value: a number that is not finite, or ownProblem. What modules provide,
  /// what comes over the network and what is set from outside are all held to this.
  std::string problemOf(const Representation& value) const;
};

/// True if the representation has a stream method (its own or its kind's), or only members that can be copied
/// as a block of memory: a trivially destructible class owns nothing.
template <typename R>
inline constexpr bool knowsHowToStream =
    !std::is_same_v<decltype(&R::stream), void (RepresentationOf<R>::*)(InStream*, OutStream*)> ||
    std::is_trivially_destructible_v<R>;

template <typename R>
class RepresentationLoaderOf final : public RepresentationLoader {
  static_assert(std::is_base_of_v<Representation, R>, "declare it with REPRESENTATION");
  static_assert(std::is_copy_assignable_v<R>, "a representation is copied from thread to thread");

  static_assert(knowsHowToStream<R>,
                "this representation has members that own memory: write its stream method");

  class Holder final : public RepresentationHolder {
  public:
    Representation& get() override { return representation_; }

  private:
    R representation_{};
  };

public:
  const std::string& name() const override { return name_; }
  const std::string& kind() const override { return kind_; }
  std::unique_ptr<RepresentationHolder> create() const override { return std::make_unique<Holder>(); }
  void copy(const Representation& from, Representation& to) const override {
    static_cast<R&>(to) = static_cast<const R&>(from);
  }
  std::optional<std::span<const char>> plainBytes(
      [[maybe_unused]] const Representation& value) const override {
    if constexpr (std::is_trivially_destructible_v<R>) {
      return memberBytes(static_cast<const R&>(value));
    } else {
      return std::nullopt;
    }
  }
  bool hasOwnCheck() const override {
    return requires(const R& r) { std::string(r.problem()); };
  }
  std::string ownProblem([[maybe_unused]] const Representation& value) const override {
    if constexpr (requires(const R& r) { std::string(r.problem()); }) {
      return static_cast<const R&>(value).problem();
    } else {
      return {};
    }
  }

private:
  static std::string kindOf() {
    if constexpr (requires { R::kindName(); }) {
      return R::kindName();
    } else {
      return "";
    }
  }

  std::string name_ = R::representationName();
  std::string kind_ = kindOf();
};

/// The one loader of a type.
template <typename R>
const RepresentationLoader& representationLoader() {
  static const RepresentationLoaderOf<R> loader;
  return loader;
}

}  // namespace plumbline
