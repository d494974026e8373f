#include "robot/MjcfDefaults.h"

#include <array>

namespace plumbline {
namespace {

using tinyxml2::XMLElement;

constexpr int deepestClass = 64;       // classes within each other
const std::string outermost = "main";  // the class of what names none

/// For MuJoCo these are one element: what they share holds for all of them.
constexpr std::array<std::string_view, 4> actuators = {"general", "motor", "position", "velocity"};
constexpr std::array<std::string_view, 5> shared = {"gear", "forcerange", "ctrlrange", "ctrllimited",
                                                    "forcelimited"};

/// Two ways to say the same: the one that stands nearer to the element holds.
std::string_view rivalOf(std::string_view key) {
  return key == "kv" ? "dampratio" : key == "dampratio" ? "kv" : "";
}

}  // namespace

void MjcfDefaults::readDefaults(const XMLElement& root) {
  for (const XMLElement* e = root.FirstChildElement("default"); e; e = e->NextSiblingElement("default"))
    readClass(*e, "", 0);
}

/// Of each class and element the attributes, those of the class around it among them. The outermost class
/// holds for all elements, whatever its name.
void MjcfDefaults::readClass(const XMLElement& e, const std::string& around, int depth) {
  if (depth > deepestClass) fail(e, "classes are nested too deeply");
  const std::string name = around.empty() ? outermost : attribute(e, "class");
  if (!around.empty()) classes_[name] = classes_[around];
  Class& mine = classes_[name];
  for (const XMLElement* c = e.FirstChildElement(); c; c = c->NextSiblingElement()) {
    if (std::string_view(c->Name()) == "default") continue;
    const bool drives = std::ranges::find(actuators, c->Name()) != actuators.end();
    for (const tinyxml2::XMLAttribute* a = c->FirstAttribute(); a; a = a->Next()) {
      if (drives && std::ranges::find(shared, a->Name()) != shared.end())
        for (const std::string_view kind : actuators) mine[std::string(kind)][a->Name()] = a->Value();
      else
        mine[c->Name()][a->Name()] = a->Value();
      if (const std::string rival(rivalOf(a->Name())); !rival.empty() && !c->Attribute(rival.c_str()))
        mine[c->Name()].erase(rival);
    }
  }
  if (around.empty() && e.Attribute("class")) classes_[e.Attribute("class")] = mine;
  for (const XMLElement* c = e.FirstChildElement("default"); c; c = c->NextSiblingElement("default"))
    readClass(*c, name, depth + 1);
}

void MjcfDefaults::complete(const XMLElement& e, const std::string& classAround) const {
  const char* own = e.Attribute("class");
  const std::string name = own ? own : classAround.empty() ? outermost : classAround;
  const auto found = classes_.find(name);
  if (found == classes_.end()) {
    if (own) fail(e, "there is no class " + name.substr(0, 60));
    return;
  }
  const auto of = found->second.find(e.Name());
  if (of == found->second.end()) return;
  // What is read later sees the element as MuJoCo does.
  auto& completed = const_cast<XMLElement&>(e);
  const bool damped = e.Attribute("kv") || e.Attribute("dampratio");
  for (const auto& [key, value] : of->second)
    if (!e.Attribute(key.c_str()) && !(damped && !rivalOf(key).empty()))
      completed.SetAttribute(key.c_str(), value.c_str());
}

std::optional<Vec2> MjcfDefaults::rangeOf(const XMLElement& e, const char* range, const char* flag) const {
  const std::vector<double> ends = numbers(e, range, 2);
  const char* const said = e.Attribute(flag);
  const bool holds =
      said && std::string_view(said) != "auto" ? std::string_view(said) == "true" : rangesHoldByThemselves;
  if (!holds || ends.size() != 2 || !(ends[0] < ends[1])) return std::nullopt;
  return Vec2(ends[0], ends[1]);
}

}  // namespace plumbline
