#include "simspark/SeeNode.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "math/Angle.h"

namespace plumbline::simspark {

namespace {

using Node = SExpressions::Node;

constexpr std::size_t mostParts = 5;  ///< that the server tells of a player

/// The points of one object: (pol distance azimuth elevation).
struct Points {
  std::array<Polar, 2> points;
  int count = 0;
};

void addPoint(NodeReader& reader, Node field, Points& to) {
  const auto words = reader.words<3>(field);
  if (std::ranges::any_of(words, [](std::string_view word) { return word == "nan" || word == "-nan"; }))
    return;
  const Polar point{reader.number(words[0]), fromDegrees(reader.number(words[1])),
                    fromDegrees(reader.number(words[2]))};
  if (to.count < 2) to.points[static_cast<std::size_t>(to.count)] = point;
  ++to.count;
}

/// Loose words are skipped, as what is not known.
Points pointsOf(NodeReader& reader, Node object) {
  Points found;
  for (Node child = object.first(); child && !reader.failed(); child = child.next())
    if (child.name() == "pol") addPoint(reader, child, found);
  return found;
}

void readPlayer(NodeReader& reader, Node node, See& see) {
  SeenPlayer& player = see.players.emplace_back();
  reader.eachField(node, [&](Node field, std::string_view name) {
    if (name == "team") {
      player.team = reader.word(field);
    } else if (name == "id") {
      player.unum = reader.integer(reader.word(field));
    } else if (const Points found = pointsOf(reader, field); found.count == 1) {
      if (player.parts.empty()) player.parts.reserve(mostParts);
      player.parts.push_back({std::string(name), found.points[0]});
    }
  });
}

}  // namespace

Vec3 Polar::cartesian() const {
  return distance * Vec3(std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
                         std::sin(elevation));
}

void readSee(NodeReader& reader, Node node, ServerMessage& message) {
  See& see = message.see.emplace();
  reader.eachField(node, [&](Node field, std::string_view name) {
    if (name == "P") return readPlayer(reader, field, see);
    if (name == "mypos") return;
    const Points found = pointsOf(reader, field);
    if (reader.failed()) return;
    if (name == "L") {
      if (found.count == 2) see.lines.push_back({found.points[0], found.points[1]});
    } else if (found.count == 1) {
      see.objects.push_back({std::string(name), found.points[0]});
    }
  });
}

}  // namespace plumbline::simspark
