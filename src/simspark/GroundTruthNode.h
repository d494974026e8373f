#pragma once
#include "simspark/NodeReader.h"
#include "simspark/ServerMessage.h"

namespace plumbline::simspark {

/// (GT ...): the true state of the robot, the ball and the players (A.6.4).
void readGroundTruth(NodeReader& reader, SExpressions::Node node, ServerMessage& message);

}  // namespace plumbline::simspark
