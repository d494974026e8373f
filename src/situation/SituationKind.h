#pragma once
#include <memory>
#include <string>

#include "framework/ConfigSection.h"
#include "situation/Situation.h"

namespace plumbline {

class CycleOfLog;

/// What is said of a kind of situation in general.
struct SituationTraits {
  const char* name;         ///< in files: the word of `decides`
  int order;                ///< its place in lists and on the page; those of the same order by name
  const char* heading;      ///< on the page of all situations
  bool knowsMode = false;   ///< whether the play mode matters to it
  bool hasRobot = true;     ///< whether its files have `robot`, and `player` for its number
  bool ofOnePlayer = true;  ///< whether a player decides, which is marked in pictures, or the team as a whole
};

/// Lines of YAML that only files of a kind have, by where they stand in a file.
struct KindText {
  std::string beforeBall{}, afterBall{}, afterOthers{};
};

/// A kind of situation: what decides in it, and what its files hold. A class in a file of its own in
/// situation/kinds/ derives from it (doc/how-to/add-a-kind-of-situation.md), and registers itself by
/// MAKE_SITUATION_KIND.
class SituationKind {
public:
  explicit SituationKind(const SituationTraits& given) : traits(given) {}
  virtual ~SituationKind() = default;
  SituationKind(const SituationKind&) = delete;
  SituationKind& operator=(const SituationKind&) = delete;

  /// Reads the keys that only files of this kind have. The ball, the others and the robot are read before.
  /// Throws as readSituation does.
  virtual void read(const ConfigSection& /*root*/, Situation& /*situation*/) const {}
  /// The part `expected` of a file. Throws as readSituation does.
  virtual std::shared_ptr<const ExpectedDecision> readExpected(const ConfigSection& section) const = 0;
  /// What read() reads, as text.
  virtual KindText text(const Situation& /*situation*/) const { return {}; }
  /// Takes from a cycle of a log what read() reads from a file. Throws as situationOfLog does.
  virtual void take(const CycleOfLog& /*cycle*/, Situation& /*situation*/) const {}

  const SituationTraits traits;
};

}  // namespace plumbline
