#include "web/DrawingSets.h"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

namespace plumbline::web {

using nlohmann::json;

namespace {

template <class... Ts>
struct Overloaded : Ts... {
  using Ts::operator()...;
};
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;  // clang 14 needs it said

std::string colourText(const Colour& c) {
  if (c.alpha == 255) return fmt::format("#{:02x}{:02x}{:02x}", c.red, c.green, c.blue);
  return fmt::format("#{:02x}{:02x}{:02x}{:02x}", c.red, c.green, c.blue, c.alpha);
}

/// Tenths of millimetres are enough to look at.
double rounded(double value) { return std::round(value * 1e4) / 1e4; }

void append(json& list, const Vec3& v) {
  for (int i = 0; i < 3; ++i) list.push_back(rounded(v[i]));
}

json shapeJson(const Shape& shape) {
  json list = json::array();
  const auto begin = [&](const char* name) { list = {name, colourText(shape.colour)}; };
  std::visit(Overloaded{[&](const Circle& c) {
                          begin("circle");
                          for (const double v : {c.centre.x(), c.centre.y(), c.radius, c.thickness})
                            list.push_back(rounded(v));
                        },
                        [&](const Line& l) {
                          begin("line");
                          append(list, l.begin);
                          append(list, l.end);
                          list.push_back(rounded(l.thickness));
                        },
                        [&](const Point& p) {
                          begin("point");
                          append(list, p.position);
                          list.push_back(rounded(p.size));
                        },
                        [&](const Sphere& s) {
                          begin("sphere");
                          append(list, s.centre);
                          list.push_back(rounded(s.radius));
                        },
                        [&](const Polygon& p) {
                          begin("polygon");
                          for (const Vec3& corner : p.corners) append(list, corner);
                        },
                        [&](const Annotation& a) {
                          begin("text");
                          append(list, a.position);
                          list.push_back(a.text);
                        }},
             shape.form);
  return list;
}

}  // namespace

bool DrawingSets::add(const Shape& shape) {
  if (numShapes >= maxShapes) return false;
  auto set = sets.find(shape.set);
  if (set == sets.end()) {
    if (sets.size() >= maxSets) return false;
    set = sets.emplace(shape.set, Set()).first;
  }
  if (set->second.drawn.size() >= maxShapesOfSet) return false;
  set->second.drawn.push_back(shape);
  ++numShapes;
  return false;
}

bool DrawingSets::swap(const std::string& prefix) {
  bool changed = false;
  for (auto set = sets.lower_bound(prefix); set != sets.end() && set->first.starts_with(prefix);) {
    auto& [shown, drawn] = set->second;
    changed = changed || !shown.empty() || !drawn.empty();
    numShapes -= shown.size();
    shown = std::exchange(drawn, {});
    set = shown.empty() ? sets.erase(set) : std::next(set);
  }
  return changed;
}

bool DrawingSets::apply(const DrawingCommand& command) {
  return std::visit(Overloaded{[&](const Shape& shape) { return add(shape); },
                               [&](const SwapSets& swapped) { return swap(swapped.prefix); },
                               [&](const AgentText& text) {
                                 if (text.text.empty()) return texts.erase(text.agent) > 0;
                                 texts[text.agent] = text;  // 256 at most
                                 return true;
                               },
                               [&](const SelectAgent& select) {
                                 selected = select.agent;
                                 return true;
                               }},
                    command);
}

void DrawingSets::clear() { *this = DrawingSets(); }

std::size_t DrawingSets::numShown() const {
  std::size_t shown = 0;
  for (const auto& [name, set] : sets) shown += set.shown.size();
  return shown;
}

std::string DrawingSets::toJson() const {
  json message = {{"kind", "drawings"}, {"sets", json::array()}, {"texts", json::array()}};
  for (const auto& [name, set] : sets) {
    if (set.shown.empty()) continue;
    json shapes = json::array();
    for (const Shape& shape : set.shown) shapes.push_back(shapeJson(shape));
    message["sets"].push_back({{"name", name}, {"shapes", std::move(shapes)}});
  }
  const auto agentJson = [](const AgentName& agent) {
    return json{{"side", agent.side == simspark::TeamSide::left ? "left" : "right"}, {"unum", agent.unum}};
  };
  for (const auto& [agent, text] : texts) {
    json entry = agentJson(agent);
    entry["colour"] = colourText(text.colour);
    entry["text"] = text.text;
    message["texts"].push_back(std::move(entry));
  }
  message["selected"] = selected ? agentJson(*selected) : json();
  // Agents may send what is no UTF-8.
  return message.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace plumbline::web
