#pragma once
#include <map>
#include <optional>
#include <span>
#include <string>

#include "optimization/Search.h"

namespace plumbline::farm {

/// Where who evaluates gets parameters from and brings costs to: the same whether the optimiser is in the
/// process (LocalSource) or behind TCP (FarmClient).
class ParameterSource {
public:
  virtual ~ParameterSource() = default;
  ParameterSource(const ParameterSource&) = delete;
  ParameterSource& operator=(const ParameterSource&) = delete;

  /// A trial, waiting for it at most so long [s]; nothing: there is none yet, or the search is over.
  virtual std::optional<Trial> next(double seconds) = 0;
  /// A cost for each of the trial's seeds.
  virtual void tell(const Trial& trial, std::span<const double> costs,
                    const std::map<std::string, double>& figures = {}) = 0;
  virtual bool isOver() const = 0;

protected:
  ParameterSource() = default;
};

/// The optimiser in this process.
class LocalSource final : public ParameterSource {
public:
  explicit LocalSource(Search& search) : search_(search) {}
  std::optional<Trial> next(double) override { return search_.next(); }
  void tell(const Trial& trial, std::span<const double> costs,
            const std::map<std::string, double>&) override {
    search_.tell(trial.number, costs);
  }
  bool isOver() const override { return search_.isDone(); }

private:
  Search& search_;
};

}  // namespace plumbline::farm
