#pragma once
#include "simspark/NodeReader.h"
#include "simspark/ServerMessage.h"

namespace plumbline::simspark {

/// Nodes of a server's message that a robot's own senses fill, and the game's state. Each reads one node, and
/// converts SimSpark's axes, degrees and signs into the project's.
void readTime(NodeReader& reader, SExpressions::Node node, ServerMessage& message);
void readGameState(NodeReader& reader, SExpressions::Node node, ServerMessage& message);
void readGyro(NodeReader& reader, SExpressions::Node node, ServerMessage& message);
void readAcceleration(NodeReader& reader, SExpressions::Node node, ServerMessage& message);
void readHingeJoint(NodeReader& reader, SExpressions::Node node, ServerMessage& message);
void readForce(NodeReader& reader, SExpressions::Node node, ServerMessage& message);
/// (hear team time self|direction text); older servers name no team.
void readHeard(NodeReader& reader, SExpressions::Node node, ServerMessage& message);

}  // namespace plumbline::simspark
