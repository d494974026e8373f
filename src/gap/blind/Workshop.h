#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "gap/blind/BlindCase.h"

namespace plumbline::gap {

/// What simulates a benchmark's reality, besides the engines for servo robots by their names
/// (servo/RobotSimulation.h): the diagnosis' own dynamics in finer steps, or a separate program.
inline const std::string blindReplay = "replay", blindProgram = "program";
/// Throws std::invalid_argument for an unknown name; the message says what to install if that is the reason.
void requireBlindEngine(const std::string& engine);

/// Writes the runs of one robot with effects into a folder, in one of the engines.
class Workshop {
public:
  /// robotName: for a separate program, whose file is `program`. The robot must outlive this object. Throws
  /// std::runtime_error if that program is missing.
  Workshop(std::string engine, std::string robotName, const Mechanism& robot,
           std::vector<std::string> programs, std::string program);

  /// Folders of the runs, in order.
  std::vector<std::string> runs() const;

  /// Replaces the folder by one run for each program. Throws std::runtime_error if the engine does not have
  /// an effect or its program fails.
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
