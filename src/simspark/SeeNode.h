#pragma once
#include "simspark/NodeReader.h"
#include "simspark/ServerMessage.h"

namespace plumbline::simspark {

/// (See ...): objects, lines and players in the head's frame. A point with a "nan" is left out, and with it
/// the line or object that it belongs to. The league's server clips lines to what is seen, and now and then
/// divides by zero there.
void readSee(NodeReader& reader, SExpressions::Node node, ServerMessage& message);

}  // namespace plumbline::simspark
