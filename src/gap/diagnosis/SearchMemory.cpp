#include "gap/diagnosis/SearchMemory.h"

#include <filesystem>
#include <new>
#include <nlohmann/json.hpp>

#include "framework/Json.h"
#include "framework/ReadFile.h"
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

SearchMemory::SearchMemory(std::string path, std::string mark, const Mechanism& mechanism, Warn warn)
    : path_(std::move(path)), mark_(std::move(mark)), warn_(std::move(warn)) {
  if (!path_.empty()) read(mechanism);
}

void SearchMemory::read(const Mechanism& mechanism) {
  std::error_code none;
  const std::uintmax_t bytes = std::filesystem::file_size(path_, none);
  if (none || bytes > mostBytes) return;
  // A file that is damaged or of other runs is as good as none: everything in it can be found again.
  try {
    const json j = parseJson(readFile(path_, mostBytes), path_);
    if (j.at("mark") != mark_) return;
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
      entries_.push_back(std::move(entry));
    }
    stored_ = entries_.size();
  } catch (const std::bad_alloc&) {
    throw;  // the file may be good
  } catch (const std::exception&) {
    entries_.clear();
  }
}

std::optional<SearchResult> SearchMemory::find(const SearchStart& start) const {
  for (const Entry& entry : entries_)
    if (entry.start == start) return entry.result;
  return std::nullopt;
}

void SearchMemory::keep(const SearchStart& start, const SearchResult& result) {
  if (path_.empty()) return;
  entries_.push_back({start, result});
  if (writable_) write();
}

void SearchMemory::write() {
  json j = {{"mark", mark_}, {"searches", json::array()}};
  for (const Entry& entry : entries_) {
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
    writeFile(path_, j.dump());
    stored_ = entries_.size();
  } catch (const std::runtime_error& error) {
    // Only time is lost where the diagnosis is stopped later.
    writable_ = false;
    if (warn_) warn_(error.what());
  }
}

void SearchMemory::forget() {
  std::error_code none;
  if (!path_.empty() && std::filesystem::is_regular_file(path_, none)) std::filesystem::remove(path_, none);
  entries_.clear();
  stored_ = 0;
}

}  // namespace plumbline::gap
