#pragma once
#include <memory>
#include <utility>

#include "parameters/Parameter.h"

namespace plumbline::simulation {

/// The parameters of a rule, whatever their type: a value that is copied and compared as one.
class RuleParameters {
public:
  /// Those of a type with PARAMETERS, with their defaults.
  template <typename P>
  static RuleParameters of() {
    return RuleParameters(std::make_unique<Values<P>>(), P::parameterList());
  }
  RuleParameters(const RuleParameters& other) : values_(other.values_->clone()), list_(other.list_) {}
  RuleParameters(RuleParameters&&) = default;
  RuleParameters& operator=(RuleParameters other) {
    std::swap(values_, other.values_);
    std::swap(list_, other.list_);
    return *this;
  }

  /// Which they are; lists of two types differ by their addresses.
  const ParameterList& list() const { return *list_; }
  /// The struct with the values.
  void* owner() { return values_->owner(); }
  const void* owner() const { return values_->owner(); }
  bool operator==(const RuleParameters& other) const;

private:
  struct AnyValues {
    virtual ~AnyValues() = default;
    virtual std::unique_ptr<AnyValues> clone() const = 0;
    virtual void* owner() = 0;
  };
  template <typename P>
  struct Values final : AnyValues {
    P parameters;
    std::unique_ptr<AnyValues> clone() const override { return std::make_unique<Values>(*this); }
    void* owner() override { return &parameters; }
  };
  RuleParameters(std::unique_ptr<AnyValues> values, const ParameterList& list)
      : values_(std::move(values)), list_(&list) {}

  std::unique_ptr<AnyValues> values_;
  const ParameterList* list_;
};

}  // namespace plumbline::simulation
