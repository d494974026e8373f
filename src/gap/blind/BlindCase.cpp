#include "gap/blind/BlindCase.h"

#include <array>
#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

#include "framework/Json.h"
#include "framework/ReadFile.h"
#include "framework/WriteFile.h"
#include "gap/record/Secret.h"

namespace plumbline::gap {

namespace {

using nlohmann::json;

constexpr std::size_t maxSealed = std::size_t{64} << 20;  // [bytes]

constexpr std::array kinds = {BlindKind::none, BlindKind::single, BlindKind::mixture, BlindKind::outside,
                              BlindKind::hard};

json effectJson(const BlindEffect& e) {
  json j = {{"effect", e.effect}, {"at", e.at}, {"value", e.value}};
  j["axis"] = e.axis.empty() ? json(nullptr) : json(e.axis);
  for (const auto& [key, value] : e.how) j["how"][key] = value;
  for (const NamedPlace& other : e.alike)
    j["alike"].push_back({{"effect", other.effect}, {"at", other.at}, {"axis", other.axis}});
  return j;
}

BlindEffect effectOf(const json& j) {
  BlindEffect e{j.at("effect"), j.at("at"), "", j.at("value"), {}, {}};
  if (j.at("axis").is_string()) e.axis = j.at("axis");
  if (j.contains("how")) e.how = j.at("how").get<std::map<std::string, std::string>>();
  if (j.contains("alike"))
    for (const json& other : j.at("alike"))
      e.alike.push_back({other.at("effect"), other.at("at"), other.at("axis")});
  return e;
}

std::string sealedPath(const std::string& folder) {
  return (std::filesystem::path(folder) / "answers.sealed").string();
}

}  // namespace

const char* nameOf(BlindKind kind) {
  switch (kind) {
    case BlindKind::none:
      return "none";
    case BlindKind::single:
      return "single";
    case BlindKind::mixture:
      return "mixture";
    case BlindKind::outside:
      return "outside";
    case BlindKind::hard:
      return "hard";
  }
  return "";
}

std::string blindSetText(const BlindSet& set) {
  json j = {{"robot", set.robot}, {"engine", set.engine}, {"battery", set.battery}, {"seed", set.seed}};
  j["cases"] = json::array();
  for (const BlindCase& c : set.cases) {
    json entry = {{"case", c.name}, {"kind", nameOf(c.kind)},          {"ratio", c.ratio},
                  {"seed", c.seed}, {"ratio_channel", c.ratioChannel}, {"effects", json::array()}};
    if (c.reference) entry["reference"] = true;
    for (const BlindEffect& e : c.effects) entry["effects"].push_back(effectJson(e));
    j["cases"].push_back(std::move(entry));
  }
  return j.dump();
}

BlindSet parseBlindSet(const std::string& text) {
  try {
    const json j = parseJson(text, "the sealed text");
    BlindSet set{j.at("robot"), j.at("engine"), j.at("battery"), j.at("seed"), {}};
    for (const json& entry : j.at("cases")) {
      BlindCase c;
      c.name = entry.at("case");
      const std::string kind = entry.at("kind");
      bool known = false;
      for (const BlindKind k : kinds)
        if (kind == nameOf(k)) c.kind = k, known = true;
      if (!known) throw std::invalid_argument("kind '" + kind + "'");
      c.ratio = entry.at("ratio");
      c.ratioChannel = entry.at("ratio_channel");
      c.seed = entry.at("seed");
      c.reference = entry.value("reference", false);
      for (const json& e : entry.at("effects")) c.effects.push_back(effectOf(e));
      set.cases.push_back(std::move(c));
    }
    return set;
  } catch (const std::bad_alloc&) {  // says nothing about the text
    throw;
  } catch (const json::exception&) {
    throw std::invalid_argument("no answers of a benchmark: a field is missing or of another kind");
  } catch (const std::exception& error) {
    throw std::invalid_argument(std::string("no answers of a benchmark: ") + error.what());
  }
}

void writeSealed(const BlindSet& set, const std::string& folder) {
  const std::string text = blindSetText(set);
  writeFile(sealedPath(folder), "sha256 " + sha256(text) + "\n" + seal(text, set.seed) + "\n");
}

BlindSet readSealed(const std::string& folder) {
  const std::string path = sealedPath(folder);
  std::string text;
  if (std::filesystem::exists(path)) try {
      text = readFile(path, maxSealed);
    } catch (const FileProblem& problem) {
      throw std::runtime_error(path + ": " + problem.what());
    }
  std::istringstream words(text);
  words.exceptions(std::ios::badbit);  // a lack of memory is not the end of the text
  std::string word, sum, sealed;
  if (!(words >> word >> sum >> sealed) || word != "sha256")
    throw std::runtime_error(path + ": no sealed answers there; bin/gap blind make writes them");
  try {
    text = unseal(sealed);
    if (sha256(text) != sum) throw std::invalid_argument("the answers were changed: SHA-256 differs");
    return parseBlindSet(text);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

std::string motorOf(const Mechanism& robot, const std::string& at) {
  const int joint = at == "*" ? robot.onlyMotor() : robot.jointIndex(at);
  return joint < 0 ? at : robot.joints[static_cast<std::size_t>(robot.motorOf(joint))].name;
}

}  // namespace plumbline::gap
