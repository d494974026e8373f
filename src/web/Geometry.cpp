#include "web/Geometry.h"

#include <nlohmann/json.hpp>
#include <span>

#include "field/FieldMarks.h"
#include "simspark/LeagueRobots.h"
#include "simspark/SceneState.h"

namespace plumbline::web {

using nlohmann::json;

namespace {

/// Where a body's joints are in its own axes, from its middle: its own, then those of what hangs on it.
json jointsJson(const RobotModel& model, std::size_t index) {
  const Link& link = model.links[index];
  json joints = json::array();
  const auto add = [&](const Vec3& place) { joints.push_back({place.x(), place.y(), place.z()}); };
  if (link.parent >= 0) add(-link.com);
  for (const Link& child : model.links)
    if (child.parent == static_cast<int>(index)) add(child.origin - link.com);
  return joints;
}

json partJson(const Link& link) {
  const Vec3 size = link.shape.size;
  json part = {{"name", link.name}};
  switch (link.shape.kind) {
    case plumbline::Shape::Kind::box:
      part["shape"] = "box";
      part["size"] = {size.x(), size.y(), size.z()};
      break;
    case plumbline::Shape::Kind::sphere:
      part["shape"] = "sphere";
      part["size"] = {size.x()};
      break;
    case plumbline::Shape::Kind::capsule:
      part["shape"] = "capsule";
      part["size"] = {size.x(), size.z()};
      break;
  }
  return part;
}

json fieldJson(const FieldSize& field) {
  const FieldMarks marks(field);
  json lines = json::array();
  for (const FieldLine& line : std::span(marks.lines).first(FieldMarks::numStraightLines))
    lines.push_back({line.begin.x(), line.begin.y(), line.end.x(), line.end.y()});
  return {{"length", field.length},
          {"width", field.width},
          {"goalWidth", field.goalWidth},
          {"goalDepth", field.goalDepth},
          {"goalHeight", field.goalHeight},
          {"barDiameter", field.goalBarDiameter},
          {"ballRadius", field.ballRadius},
          {"lines", std::move(lines)},
          {"circle", {0, 0, field.centreCircleRadius}}};
}

}  // namespace

std::string geometryMessage(const FieldSize& field) {
  json types = json::array();
  for (int type = 0; type < numSimsparkTypes(); ++type) {
    const RobotModel& model = simsparkRobot(type);
    json parts = json::array();
    for (const std::string& name : simspark::sceneBodies(type)) {
      const auto index = static_cast<std::size_t>(model.linkIndex(name));
      parts.push_back(partJson(model.links[index]));
      parts.back()["joints"] = jointsJson(model, index);
    }
    types.push_back({{"parts", std::move(parts)}});
  }
  return json{{"kind", "geometry"}, {"field", fieldJson(field)}, {"types", std::move(types)}}.dump();
}

}  // namespace plumbline::web
