#pragma once
#include <map>
#include <set>
#include <string>
#include <vector>

#include "framework/ConfigurationError.h"
#include "gap/run/Channel.h"
#include "robot/Mechanism.h"

namespace plumbline::gap {

/// A unit that a map does not name and that the values show.
struct GuessedUnit {
  std::string unit;  ///< as ImportUnits.h calls it
  std::string why;   ///< for people
};

/// The values fit more than one unit, or none; what() says which and why.
class UnclearUnit : public ConfigurationError {
public:
  using ConfigurationError::ConfigurationError;
};

/// The unit of a column of times by their median step: seconds or a thousandth, ... of them, so that the
/// rate is within 12 times the one expected. Throws UnclearUnit.
GuessedUnit guessTimeUnit(double step, double expectedHz);

/// Guesses units of channels by the robot's limits and by each other. All channels of a kind have one unit,
/// joints that slide apart from those that turn.
class UnitGuess {
public:
  /// A channel as it is in the recording: its value is factor * unit * raw + offset.
  struct Raw {
    std::string place;
    const std::vector<double>* values = nullptr;
    double factor = 1, offset = 0;
  };
  struct Known {
    const std::vector<double>* t = nullptr;               ///< [s]
    std::map<std::string, std::vector<double>> channels;  ///< whose units are known, in the run's units
    std::set<std::string> unsignedKinds;                  ///< Run::unsignedKinds
    bool freeBase = false;
  };

  /// `robot`: null if its file is not known. Both must outlive this object.
  UnitGuess(const Mechanism* robot, const Known& known) : robot_(robot), known_(known) {}

  /// `sliding`: the channels are of prismatic joints. Throws UnclearUnit.
  GuessedUnit of(ChannelKind kind, const std::vector<Raw>& channels, bool sliding) const;

  /// Whether `of` can find the unit of channels of this kind; others have the run's unit.
  static bool guesses(ChannelKind kind);

private:
  GuessedUnit angle(ChannelKind kind, const std::vector<Raw>& channels) const;
  GuessedUnit length(const std::vector<Raw>& channels) const;
  GuessedUnit speed(const std::vector<Raw>& channels, bool sliding) const;
  GuessedUnit torque(const std::vector<Raw>& channels) const;
  GuessedUnit current(const std::vector<Raw>& channels) const;
  GuessedUnit voltage(const std::vector<Raw>& channels) const;
  static GuessedUnit share(const std::vector<Raw>& channels);
  GuessedUnit acceleration(const std::vector<Raw>& channels) const;
  GuessedUnit rotation(const std::vector<Raw>& channels) const;
  GuessedUnit force(const std::vector<Raw>& channels) const;
  const Mechanism::Joint* joint(const std::string& name) const;

  const Mechanism* robot_;
  const Known& known_;
};

}  // namespace plumbline::gap
