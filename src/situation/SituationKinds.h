#pragma once
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "situation/SituationKind.h"

namespace plumbline {

/// Takes a kind in before main. A second one of the same name ends the program start: that is a mistake of
/// the build.
class SituationKindLoader {
public:
  explicit SituationKindLoader(std::unique_ptr<const SituationKind> kind);
};

/// MAKE_SITUATION_KIND(GoalieSituationKind): in the kind's .cpp.
#define MAKE_SITUATION_KIND(Kind) \
  static const ::plumbline::SituationKindLoader Kind##Loader(std::make_unique<Kind>());

/// The kinds linked into the program, in their order. Complete once main runs.
const std::vector<std::unique_ptr<const SituationKind>>& situationKinds();

/// Their names in that order.
std::vector<std::string> situationKindNames();

/// The kind of that name. Throws std::invalid_argument if there is none.
const SituationKind& situationKind(std::string_view name);

}  // namespace plumbline
