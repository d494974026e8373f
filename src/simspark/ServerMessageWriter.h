#pragma once
#include <string>

#include "simspark/ServerMessage.h"

namespace plumbline::simspark {

/// Appends a message (without frame) as the league's server writes it: order of nodes, blanks, two decimals,
/// its axes, degrees and signs. Joints without a value are left out. A GT node, if there is one, follows ACC.
/// groundTruthDecimals: digits behind the point in GT alone; two, as the thesis shows it, is a centimetre.
void appendServerMessage(std::string& out, const ServerMessage& message, int groundTruthDecimals = 2);

}  // namespace plumbline::simspark
