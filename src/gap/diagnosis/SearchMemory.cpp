#include "gap/diagnosis/SearchMemory.h"

#include <bit>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "framework/WriteFile.h"

namespace plumbline::gap {

namespace {

using nlohmann::json;

constexpr std::uintmax_t mostBytes = 64u << 20;

/// FNV-1a of all that the diagnosis sees.
std::string markOf(const Evaluator& evaluator) {
  std::uint64_t hash = 0xcbf29ce484222325;
  const auto byte = [&](unsigned char b) { hash = (hash ^ b) * 0x100000001b3; };
  const auto text = [&](std::string_view s) {
    for (const char c : s) byte(static_cast<unsigned char>(c));
    byte(0);
  };
  const auto series = [&](const std::vector<double>& values) {
    for (const double v : values) {
      const auto bits = std::bit_cast<std::uint64_t>(v);
      for (int shift = 0; shift < 64; shift += 8) byte(static_cast<unsigned char>(bits >> shift));
    }
  };
  text(evaluator.mechanism().name);
  for (const Effect* effect : effects()) text(effect->id);
  for (const Mechanism::Joint& joint : evaluator.mechanism().joints)
    series({joint.servo.kp, joint.servo.kd, joint.servo.armature, joint.maxTorque, joint.maxSpeed});
  for (const Mechanism::Link& link : evaluator.mechanism().links)
    series({link.mass, link.com.x(), link.com.y(), link.com.z()});
  for (const Trial& trial : evaluator.evidence().trials()) {
    series(trial.time);
    for (const auto* list : {&trial.command, &trial.stiffness, &trial.voltage})
      for (const std::vector<double>& values : *list) series(values);
    for (const Signal& signal : trial.signals) {
      text(signal.name);
      series(signal.values);
    }
  }
  char mark[17];
  std::snprintf(mark, sizeof mark, "%016llx", static_cast<unsigned long long>(hash));
  return mark;
}

json jsonOf(const Cause& cause) {
  return {cause.effect->id, cause.place.at, std::string(cause.place.axis ? 1 : 0, cause.place.axis),
          cause.value,      cause.variant,  cause.notIn};
}

Cause causeOf(const json& j, const Mechanism& mechanism) {
  const Effect* effect = findEffect(j.at(0).get<std::string>());
  if (!effect) throw std::invalid_argument("an effect that the library lacks");
  return {effect, findPlace(*effect, mechanism, j.at(1).get<std::string>(), j.at(2).get<std::string>()),
          j.at(3).get<double>(), j.at(4).get<int>(), j.at(5).get<std::vector<std::string>>()};
}

}  // namespace

SearchMemory::SearchMemory(std::string path_, const Evaluator& evaluator) : path(std::move(path_)) {
  if (path.empty()) return;
  mark = markOf(evaluator);
  read(evaluator.mechanism());
}

void SearchMemory::read(const Mechanism& mechanism) {
  std::error_code none;
  const std::uintmax_t bytes = std::filesystem::file_size(path, none);
  if (none || bytes > mostBytes) return;
  std::ifstream file(path);
  // A file that is damaged or of other runs is as good as none: everything in it can be found again.
  try {
    const json j = json::parse(file);
    if (j.at("mark") != mark) return;
    for (const json& stored : j.at("searches")) {
      Entry entry;
      for (const json& cause : stored.at("base")) entry.base.push_back(causeOf(cause, mechanism));
      for (const json& found : stored.at("found")) {
        Candidate candidate;
        candidate.cause = causeOf(found.at(0), mechanism);
        candidate.fit.fitting = found.at(1);
        candidate.fit.judging = found.at(2);
        entry.result.candidates.push_back(std::move(candidate));
      }
      entry.result.lostCycles = stored.at("lost").get<std::vector<std::vector<std::uint8_t>>>();
      entries.push_back(std::move(entry));
    }
  } catch (const std::exception&) {
    entries.clear();
  }
}

std::optional<SearchResult> SearchMemory::find(const Explanation& base) const {
  for (const Entry& entry : entries)
    if (entry.base == base) return entry.result;
  return std::nullopt;
}

void SearchMemory::keep(const Explanation& base, const SearchResult& result) {
  if (path.empty()) return;
  entries.push_back({base, result});
  for (Candidate& candidate : entries.back().result.candidates) candidate.fit.squares.clear();
  write();
}

void SearchMemory::write() const {
  json j = {{"mark", mark}, {"searches", json::array()}};
  for (const Entry& entry : entries) {
    json stored = {{"base", json::array()}, {"found", json::array()}, {"lost", entry.result.lostCycles}};
    for (const Cause& cause : entry.base) stored["base"].push_back(jsonOf(cause));
    for (const Candidate& c : entry.result.candidates)
      stored["found"].push_back({jsonOf(c.cause), c.fit.fitting, c.fit.judging});
    j["searches"].push_back(std::move(stored));
  }
  writeFile(path, j.dump());
}

void SearchMemory::forget() {
  std::error_code none;
  if (!path.empty()) std::filesystem::remove(path, none);
  entries.clear();
}

}  // namespace plumbline::gap
