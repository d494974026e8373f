#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "gap/blind/BlindCase.h"

namespace plumbline::gap {

/// What simulates a benchmark's reality, beside the engines for servo robots by their names
/// (simulation/servo/RobotSimulation.h): the dynamics that explain, in finer steps; a program of its own.
inline const std::string blindReplay = "replay", blindProgram = "program";
/// Throws std::invalid_argument for a name of none, with what to install where it is that.
void requireBlindEngine(const std::string& engine);

/// Writes the runs of one robot with effects into a folder, in one of the engines.
class Workshop {
public:
  /// robotName: for a program of its own, whose file `program` is. The robot must outlive it. Throws
  /// std::runtime_error where that program is not there.
  Workshop(std::string engine, std::string robotName, const Mechanism& robot,
           std::vector<std::string> programs, std::string program);

  /// Folders of the runs, in order.
  std::vector<std::string> runs() const;

  /// Replaces the folder by one run for each program. Throws std::runtime_error where the engine lacks an
  /// effect or its program fails.
  void write(const std::vector<BlindEffect>& effects, std::uint64_t seed, bool noise,
             const std::string& folder) const;

private:
  void writeByProgram(const std::vector<BlindEffect>& effects, std::uint64_t seed, bool noise,
                      const std::string& folder) const;
  void writeHere(const std::vector<BlindEffect>& effects, std::uint64_t seed, bool noise,
                 const std::string& folder) const;

  const std::string engine_, robotName_;
  const Mechanism& robot_;
  const std::vector<std::string> programs_;
  const std::string program_;
};

}  // namespace plumbline::gap
