#pragma once
#include <string>

#include "situation/Situation.h"

namespace plumbline {

class ConfigSection;

/// The decision that people expect of a decider: the part `expected` of a situation's file. Throws as
/// readSituation does.
Expected readExpected(const ConfigSection& section, Decider decider);

/// That part as a line of YAML; empty: nothing is expected.
std::string expectedText(const Expected& expected);

/// The same for people: "kicks between 5 and 52 degrees left". `player`: whose decision it is.
std::string expectedWords(const Expected& expected, int player);

}  // namespace plumbline
