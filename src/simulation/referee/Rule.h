#pragma once
#include <cstdint>

#include "parameters/Parameter.h"
#include "simulation/referee/Match.h"
#include "simulation/referee/RuleRegistry.h"

namespace plumbline::simulation {

/// Something that a player says, and one of those who may hear it.
struct Words {
  std::uint64_t seed = 0, cycle = 0;  ///< of the simulation
  int speaker = 0, listener = 0;      ///< ids of the players
};

/// A rule of the game. Its own file makes it known by MAKE_RULE and declares its parameters; nothing else
/// lists it. A referee has one object of each rule and calls it in every cycle, in this order of steps; in
/// each step the rules come in the order of their numbers.
class Rule {
public:
  /// What a file of rules (doc/reference/rules.yaml) can set of a rule: a rule with parameters has a struct
  /// of this name.
  struct Parameters {
    PARAMETERS(Parameters)
  };

  virtual ~Rule() = default;
  /// Before the play mode is used: may change the mode for judging this cycle.
  virtual void begin(Match&) {}
  /// What the play mode (match.mode) and the ball demand.
  virtual void play(Match&) {}
  virtual void afterPlay(Match&) {}
  /// Fouls, while play is not suspended: of all players at once, ...
  virtual void judgeAll(Match&) {}
  /// ... of a player by itself, as long as it is not called for another foul (Participant::commit), ...
  virtual void judgePlayer(Match&, Participant&) {}
  /// ... and of those who stand together.
  virtual void judgeGroups(Match&) {}
  /// What follows from the fouls called.
  virtual void punish(Match&) {}
  virtual void end(Match&) {}
  /// A player requests pass mode.
  virtual void passAsked(Match&, const Participant&) {}
  /// A player speaks: whether another one does not hear it. In any order, so it depends on nothing else.
  virtual bool loses(const Rules&, const Words&) const { return false; }
};

}  // namespace plumbline::simulation

/// MAKE_RULE(Charging, "charging", 100) in the rule's .cpp: the class, its section in a file of rules, and
/// its place in the order of rules. Rules of the same number come in the order of their names.
#define MAKE_RULE(Class, name, order)                                                            \
  static const ::plumbline::simulation::RuleLoader plumblineRule##Class(                         \
      {name, order,                                                                              \
       [] { return std::unique_ptr<::plumbline::simulation::Rule>(std::make_unique<Class>()); }, \
       ::plumbline::simulation::RuleParameters::of<Class::Parameters>()});
