#pragma once
#include <string>
#include <vector>

#include "framework/ConfigSection.h"

namespace plumbline::training {

/// A number that a search varies, by the path of its parameter, and the standard deviation of the first
/// candidates, in the parameter's unit.
struct FirstStep {
  std::string path;
  double size = 0;
  std::string place;  ///< where it is written, for error texts: `file:line: key`
};

/// Those of a map, in the order of the file; maps in it make paths with dots. Throws ConfigurationError for a
/// step that is not a number from 1e-6 to 1e6.
std::vector<FirstStep> firstStepsIn(const ConfigSection& section);

/// Those of a search: the map of this name in config/search_steps.yaml, which must be there.
std::vector<FirstStep> firstSteps(const std::string& search);

/// Throws ConfigurationError, with the nearest name, for the first step whose path is not among those known.
void checkPaths(const std::vector<FirstStep>& steps, const std::vector<std::string>& known);

}  // namespace plumbline::training
