#pragma once
#include <string>

#include "field/FieldSize.h"
#include "situation/Situation.h"

namespace plumbline {

/// A situation from above as an SVG picture: the part of the field in which everybody is. It shows players
/// with numbers and headings, the ball, who decides, where the ball and mates go, and the decision that
/// people expect. Below it are `name`, what it is about and that decision in words.
std::string situationPicture(const Situation& situation, const std::string& name, const FieldSize& field);

}  // namespace plumbline
