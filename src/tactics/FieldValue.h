#pragma once
#include <string>
#include <vector>

#include "framework/ConfigSection.h"
#include "tactics/FieldGrid.h"

namespace plumbline {

/// The value of a ball for a team: the probability that the next goal is ours minus the probability that it
/// is theirs. It depends on the ball's place and on which team is nearer to it. config/field_value.yaml holds
/// it; bin/learnvalue learns it from games (FieldValueLearner).
class FieldValue {
public:
  /// A value for each point of the grid, in its order.
  FieldValue(FieldGrid grid, std::vector<double> values);
  /// Throws ConfigurationError with file, line and key.
  explicit FieldValue(const ConfigSection& file);

  double at(const BallState& state) const;
  const FieldGrid& grid() const { return grid_; }
  /// The file's text: x and y of the grid, and a table for each advantage with a row for each y.
  std::string yaml() const;

private:
  FieldGrid grid_;
  std::vector<double> values_;
};

}  // namespace plumbline
