#include "web/Geometry.h"

#include <nlohmann/json.hpp>

#include "robot/RobotModel.h"
#include "simspark/SceneState.h"
#include "simulation/Field.h"
#include "simulation/sensors/FieldMarks.h"

namespace plumbline::web {

using nlohmann::json;

namespace {

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

json fieldJson() {
  using namespace simulation;
  json lines = json::array();
  for (const FieldLine& line : fieldLines())
    lines.push_back({line.begin.x(), line.begin.y(), line.end.x(), line.end.y()});
  return {{"length", fieldLength},    {"width", fieldWidth},      {"goalWidth", goalWidth},
          {"goalDepth", goalDepth},   {"goalHeight", goalHeight}, {"barDiameter", goalBarDiameter},
          {"ballRadius", ballRadius}, {"lines", std::move(lines)}};
}

}  // namespace

std::string geometryMessage() {
  json types = json::array();
  for (int type = 0; type < numSimsparkTypes; ++type) {
    const RobotModel model = simsparkRobot(type);
    json parts = json::array();
    for (const std::string& name : simspark::sceneBodies(type))
      parts.push_back(partJson(model.links[static_cast<std::size_t>(model.linkIndex(name))]));
    types.push_back({{"parts", std::move(parts)}});
  }
  return json{{"kind", "geometry"}, {"field", fieldJson()}, {"types", std::move(types)}}.dump();
}

}  // namespace plumbline::web
