#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "robot/Mechanism.h"

namespace plumbline::gap {

/// Engine of a set whose reality is recordings of a real robot.
inline const std::string blindRecordings = "recordings";

/// An effect at a place.
struct NamedPlace {
  std::string effect, at, axis;
};

/// An effect of a case's robot, from the library or outside of it. Names as in doc/reference/gap-answer.md.
struct BlindEffect {
  std::string effect, at, axis;  ///< axis empty where there is none
  double value = 0;
  std::map<std::string, std::string> how;  ///< the form, if there is more than one
  /// Other causes that undo it in the replay of these recordings: the same thing in another name.
  std::vector<NamedPlace> alike = {};
};

/// Kind of a case. `hard`: a single effect of small size that is easily confused with another one.
enum class BlindKind { none, single, mixture, outside, hard };
const char* nameOf(BlindKind kind);

/// One case of a benchmark with its answer.
struct BlindCase {
  std::string name;  ///< of its folder; has no meaning
  BlindKind kind = BlindKind::none;
  std::vector<BlindEffect> effects;
  /// Severity: root mean square gap beyond the noise over the noise, in the channel and run that show it
  /// best.
  double ratio = 0;
  std::string ratioChannel;
  std::uint64_t seed = 0;
  /// Of a set made from recordings: nothing is planted, and the other cases are compared with its answer.
  bool reference = false;

  bool inLibrary() const { return kind != BlindKind::none && kind != BlindKind::outside; }
  bool isSingle() const { return kind == BlindKind::single || kind == BlindKind::hard; }
};

/// A benchmark's answers, and how it was made.
struct BlindSet {
  std::string robot, engine, battery;
  std::uint64_t seed = 0;
  std::vector<BlindCase> cases;

  bool fromRecordings() const { return engine == blindRecordings; }
};

/// The set as JSON text, and back; throws std::invalid_argument for other text.
std::string blindSetText(const BlindSet& set);
BlindSet parseBlindSet(const std::string& text);

/// Writes and reads FOLDER/answers.sealed, sealed only against accidental reading. The file holds the SHA-256
/// of the clear text, which reading checks. Throws std::runtime_error in one line.
void writeSealed(const BlindSet& set, const std::string& folder);
BlindSet readSealed(const std::string& folder);

/// Hexadecimal SHA-256 (FIPS 180-4).
std::string sha256(const std::string& text);

/// Name of a place's motor: for joints that share one, the driver; for all joints (*) of a robot with one
/// motor, its joint; else the place itself.
std::string motorOf(const Mechanism& robot, const std::string& at);

}  // namespace plumbline::gap
