#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "gap/record/Excitation.h"

namespace plumbline::gap {

/// Reads a program for a robot. doc/reference/excitation-programs.md describes the file. `seed` moves all
/// that is random in it; 0 leaves the file's own seeds. Throws ConfigurationError naming file, line and key:
/// a joint the robot lacks, an unknown wave, a program longer than an hour.
Excitation readExcitation(const std::string& file, const Mechanism& robot, std::uint64_t seed = 0);

/// `folder`/`name`.yaml, without a folder that of the configuration; the error names the programs there are.
Excitation findExcitation(const std::string& name, const Mechanism& robot, std::uint64_t seed = 0,
                          const std::string& folder = "");

/// The program as a file that reads as the same commands for the same robot.
std::string excitationText(const Excitation& excitation, const Mechanism& robot);

/// The standard batteries, by name: what a robot hung up plays, and what one on its feet plays besides.
std::vector<std::string> hangingBattery();
std::vector<std::string> standingBattery();

}  // namespace plumbline::gap
