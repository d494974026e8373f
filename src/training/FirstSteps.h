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

/// Those below a key of config/search_steps.yaml ("positioning"), in the order of the file. Throws
/// ConfigurationError if the key is not there, and for a step that is not a number above 0.
std::vector<FirstStep> firstSteps(const std::string& key);

/// The same of a map.
std::vector<FirstStep> firstStepsIn(const ConfigSection& section);

/// Throws ConfigurationError, with the nearest name, for the first step whose path is not among those known.
void checkPaths(const std::vector<FirstStep>& steps, const std::vector<std::string>& known);

}  // namespace plumbline::training
