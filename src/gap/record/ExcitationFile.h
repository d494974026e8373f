#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "gap/record/Excitation.h"

namespace plumbline::gap {

/// Reads a program for a robot. doc/reference/excitation-programs.md describes the file. `seed` changes
/// everything random in it; 0 keeps the file's own seeds. Throws ConfigurationError naming file, line and
/// key: a joint that the robot does not have, an unknown wave, a program longer than an hour.
Excitation readExcitation(const std::string& file, const Mechanism& robot, std::uint64_t seed = 0);

/// Reads `folder`/`name`.yaml, by default from the configuration; the error lists the existing programs.
Excitation findExcitation(const std::string& name, const Mechanism& robot, std::uint64_t seed = 0,
                          const std::string& folder = "");

/// The program as the text of a file that gives the same commands for the same robot.
std::string excitationText(const Excitation& excitation, const Mechanism& robot);

/// Names of the standard programs: for a robot that is hung up, and the further ones for a robot on its feet.
std::vector<std::string> hangingBattery();
std::vector<std::string> floatingBaseBattery();

}  // namespace plumbline::gap
