#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "framework/Shapes.h"

namespace plumbline::simspark {

/// As much of a datagram is read by viewers of the league.
constexpr std::size_t maxDrawingDatagram = 512;

/// The shapes as datagrams in RoboViz's format, each whole in itself; the last one shows the set in place of
/// what it showed. `mirrored`: for the right team, whose field frame is turned by half a turn against the
/// viewer's. A shape that the format has no digits for is left out; a polygon of many corners becomes
/// several.
std::vector<std::string> roboVizDatagrams(std::string_view set, const std::vector<shapes::Shape>& drawn,
                                          bool mirrored);

}  // namespace plumbline::simspark
