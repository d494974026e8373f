#include "gap/diagnosis/SearchMemory.h"

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "framework/Json.h"
#include "framework/WriteFile.h"

namespace plumbline::gap {

namespace {

using nlohmann::json;

constexpr std::uintmax_t mostBytes = 64u << 20;

json jsonOf(const Cause& cause) {
  return {cause.effect->id, cause.place.at, std::string(cause.place.axis ? 1 : 0, cause.place.axis),
          cause.value,      cause.variant,  cause.inactiveIn};
}

Cause causeOf(const json& j, const Mechanism& mechanism) {
  const Effect* effect = findEffect(j.at(0).get<std::string>());
  if (!effect) throw std::invalid_argument("an effect that the library lacks");
  return {effect, findPlace(*effect, mechanism, j.at(1).get<std::string>(), j.at(2).get<std::string>()),
          j.at(3).get<double>(), j.at(4).get<int>(), j.at(5).get<std::vector<std::string>>()};
}

std::vector<std::vector<std::uint8_t>> cyclesOf(const json& j) {
  return j.get<std::vector<std::vector<std::uint8_t>>>();
}

}  // namespace

SearchMemory::SearchMemory(std::string path_, std::string mark_, const Mechanism& mechanism, Warn warn_)
    : path(std::move(path_)), mark(std::move(mark_)), warn(std::move(warn_)) {
  if (!path.empty()) read(mechanism);
}

void SearchMemory::read(const Mechanism& mechanism) {
  std::error_code none;
  const std::uintmax_t bytes = std::filesystem::file_size(path, none);
  if (none || bytes > mostBytes) return;
  std::ifstream file(path);
  // A file that is damaged or of other runs is as good as none: everything in it can be found again.
  try {
    const json j = parseJson(std::string(std::istreambuf_iterator<char>(file), {}), path);
    if (j.at("mark") != mark) return;
    for (const json& stored : j.at("searches")) {
      Entry entry;
      for (const json& cause : stored.at("base")) entry.start.base.push_back(causeOf(cause, mechanism));
      entry.start.leastGain = stored.at("least_gain");
      entry.start.lostCycles = cyclesOf(stored.at("lost_before"));
      for (const json& found : stored.at("found")) {
        Candidate candidate;
        candidate.cause = causeOf(found.at(0), mechanism);
        candidate.fit.fitting = found.at(1);
        candidate.fit.judging = found.at(2);
        entry.result.candidates.push_back(std::move(candidate));
      }
      entry.result.lostCycles = cyclesOf(stored.at("lost"));
      entries.push_back(std::move(entry));
    }
    stored = entries.size();
  } catch (const std::exception&) {
    entries.clear();
  }
}

std::optional<SearchResult> SearchMemory::find(const SearchStart& start) const {
  for (const Entry& entry : entries)
    if (entry.start == start) return entry.result;
  return std::nullopt;
}

void SearchMemory::keep(const SearchStart& start, const SearchResult& result) {
  if (path.empty()) return;
  entries.push_back({start, result});
  if (writable) write();
}

void SearchMemory::write() {
  json j = {{"mark", mark}, {"searches", json::array()}};
  for (const Entry& entry : entries) {
    json stored = {{"base", json::array()},
                   {"least_gain", entry.start.leastGain},
                   {"lost_before", entry.start.lostCycles},
                   {"found", json::array()},
                   {"lost", entry.result.lostCycles}};
    for (const Cause& cause : entry.start.base) stored["base"].push_back(jsonOf(cause));
    for (const Candidate& c : entry.result.candidates)
      stored["found"].push_back({jsonOf(c.cause), c.fit.fitting, c.fit.judging});
    j["searches"].push_back(std::move(stored));
  }
  try {
    writeFile(path, j.dump());
    stored = entries.size();
  } catch (const std::runtime_error& error) {
    // Only time is lost where the diagnosis is stopped later.
    writable = false;
    if (warn) warn(error.what());
  }
}

void SearchMemory::forget() {
  std::error_code none;
  if (!path.empty() && std::filesystem::is_regular_file(path, none)) std::filesystem::remove(path, none);
  entries.clear();
  stored = 0;
}

}  // namespace plumbline::gap
