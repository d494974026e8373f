#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "robot/Mechanism.h"

namespace plumbline::gap {

/// An effect that a case's robot has: of the library, or one that it lacks. Names as in the contract.
struct BlindEffect {
  std::string effect, at, axis;  ///< axis empty where there is none
  double value = 0;
  std::map<std::string, std::string> how;  ///< where it can be built in more than one way, which
};

/// What a case is for. `hard`: a single whose neighbour in the library looks alike, at a small size.
enum class BlindKind { none, single, mixture, outside, hard };
const char* nameOf(BlindKind kind);

/// One case of a benchmark with its answer.
struct BlindCase {
  std::string name;  ///< of its folder; says nothing
  BlindKind kind = BlindKind::none;
  std::vector<BlindEffect> effects;
  /// Severity: root mean square gap beyond the noise over the noise, in the channel and run that show it
  /// best.
  double ratio = 0;
  std::string ratioChannel;
  std::uint64_t seed = 0;

  bool inLibrary() const { return kind != BlindKind::none && kind != BlindKind::outside; }
  bool isSingle() const { return kind == BlindKind::single || kind == BlindKind::hard; }
};

/// A benchmark's answers, and how it was made.
struct BlindSet {
  std::string robot, engine, battery;
  std::uint64_t seed = 0;
  std::vector<BlindCase> cases;
};

/// The set as JSON text, and back; throws std::invalid_argument for what is none.
std::string blindSetText(const BlindSet& set);
BlindSet parseBlindSet(const std::string& text);

/// Writes and reads FOLDER/answers.sealed: sealed against accidental reading, no more than that; the file
/// holds the SHA-256 of the clear text, which reading checks. Throws std::runtime_error in one line.
void writeSealed(const BlindSet& set, const std::string& folder);
BlindSet readSealed(const std::string& folder);

/// Hexadecimal SHA-256 (FIPS 180-4).
std::string sha256(const std::string& text);

/// A place's motor: of joints that share one the driver's name, of all joints (*) that share one its joint's,
/// else the place itself.
std::string motorOf(const Mechanism& robot, const std::string& at);

}  // namespace plumbline::gap
