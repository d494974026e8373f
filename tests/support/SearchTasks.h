#pragma once
#include <gtest/gtest.h>

#include <string>

#include "training/SearchTask.h"

namespace plumbline::training {

/// The numbers with which a search of the task begins.
inline Eigen::VectorXd startOf(const SearchTask& task) {
  Eigen::VectorXd x(static_cast<Eigen::Index>(task.parameters().size()));
  for (Eigen::Index i = 0; i < x.size(); ++i) x[i] = task.parameters()[static_cast<std::size_t>(i)].start;
  return x;
}

inline double figure(const TaskOutcome& outcome, const std::string& name) {
  for (const auto& [key, value] : outcome.figures)
    if (key == name) return value;
  ADD_FAILURE() << "no figure " << name;
  return 0;
}

inline void expectSame(const TaskOutcome& a, const TaskOutcome& b) {
  EXPECT_EQ(a.cost, b.cost);
  EXPECT_EQ(a.figures, b.figures);
}

}  // namespace plumbline::training
