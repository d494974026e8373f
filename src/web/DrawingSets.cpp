#include "web/DrawingSets.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "inspect/TreeStream.h"

namespace plumbline::web {

using nlohmann::json;

namespace {

template <class... Ts>
struct Overloaded : Ts... {
  using Ts::operator()...;
};
template <class... Ts>
Overloaded(Ts...) -> Overloaded<Ts...>;  // clang 14 needs it said

json shapeJson(const Shape& shape) {
  inspect::Tree tree;
  inspect::TreeOutStream out(tree);
  shapes::writeShape(out, {shape.form, shape.colour});
  return inspect::treeJson(tree);
}

}  // namespace

bool DrawingSets::add(const Shape& shape) {
  if (numShapes_ >= maxShapes) return false;
  auto set = sets_.find(shape.set);
  if (set == sets_.end()) {
    if (sets_.size() >= maxSets) return false;
    set = sets_.emplace(shape.set, Set()).first;
  }
  if (set->second.drawn.size() >= maxShapesOfSet) return false;
  set->second.drawn.push_back(shape);
  ++numShapes_;
  return false;
}

bool DrawingSets::swap(const std::string& prefix) {
  bool changed = false;
  for (auto set = sets_.lower_bound(prefix); set != sets_.end() && set->first.starts_with(prefix);) {
    auto& [shown, drawn] = set->second;
    changed = changed || !shown.empty() || !drawn.empty();
    numShapes_ -= shown.size();
    shown = std::exchange(drawn, {});
    set = shown.empty() ? sets_.erase(set) : std::next(set);
  }
  return changed;
}

bool DrawingSets::apply(const DrawingCommand& command) {
  return std::visit(Overloaded{[&](const Shape& shape) { return add(shape); },
                               [&](const SwapSets& swapped) { return swap(swapped.prefix); },
                               [&](const AgentText& text) {
                                 if (text.text.empty()) return texts_.erase(text.agent) > 0;
                                 texts_[text.agent] = text;  // 256 at most
                                 return true;
                               },
                               [&](const SelectAgent& select) {
                                 selected_ = select.agent;
                                 return true;
                               }},
                    command);
}

void DrawingSets::clear() { *this = DrawingSets(); }

std::size_t DrawingSets::numShown() const {
  std::size_t shown = 0;
  for (const auto& [name, set] : sets_) shown += set.shown.size();
  return shown;
}

std::string DrawingSets::toJson() const {
  json message = {{"kind", "drawings"}, {"sets", json::array()}, {"texts", json::array()}};
  for (const auto& [name, set] : sets_) {
    if (set.shown.empty()) continue;
    json shapes = json::array();
    for (const Shape& shape : set.shown) shapes.push_back(shapeJson(shape));
    message["sets"].push_back({{"name", name}, {"shapes", std::move(shapes)}});
  }
  const auto agentJson = [](const AgentName& agent) {
    return json{{"side", agent.side == simspark::TeamSide::left ? "left" : "right"}, {"unum", agent.unum}};
  };
  for (const auto& [agent, text] : texts_) {
    json entry = agentJson(agent);
    entry["colour"] = shapes::colourText(text.colour);
    entry["text"] = text.text;
    message["texts"].push_back(std::move(entry));
  }
  message["selected"] = selected_ ? agentJson(*selected_) : json();
  // Agents may send what is no UTF-8.
  return message.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace plumbline::web
