#include "gap/diagnosis/SearchMemory.h"

#include <nlohmann/json.hpp>

#include "gap/diagnosis/FormJson.h"

namespace plumbline::gap {

namespace {

using nlohmann::json;

json jsonOf(const Cause& cause) { return {jsonOfForm(cause), cause.value}; }

Cause causeOf(const json& j, const Mechanism& mechanism) {
  Cause cause = formOf(j.at(0), mechanism);
  cause.value = j.at(1).get<double>();
  return cause;
}

std::vector<std::vector<std::uint8_t>> cyclesOf(const json& j) {
  return j.get<std::vector<std::vector<std::uint8_t>>>();
}

}  // namespace

SearchMemory::SearchMemory(std::string path, std::string mark, const Mechanism& mechanism,
                           MemoryFile::Warn warn)
    : file_(std::move(path), std::move(mark), std::move(warn)) {
  if (file_.read([&](const json& searches) { take(searches, mechanism); }))
    stored_ = entries_.size();
  else
    entries_.clear();
}

void SearchMemory::take(const json& searches, const Mechanism& mechanism) {
  for (const json& stored : searches) {
    Entry entry;
    for (const json& cause : stored.at("base")) entry.start.base.push_back(causeOf(cause, mechanism));
    entry.start.leastGain = stored.at("least_gain");
    entry.start.lostCycles = cyclesOf(stored.at("lost_before"));
    for (const json& found : stored.at("found")) {
      FittedCause candidate;
      candidate.cause = causeOf(found.at(0), mechanism);
      candidate.fit.fitting = found.at(1);
      candidate.fit.judging = found.at(2);
      entry.result.candidates.push_back(std::move(candidate));
    }
    entry.result.lostCycles = cyclesOf(stored.at("lost"));
    entries_.push_back(std::move(entry));
  }
}

std::optional<SearchResult> SearchMemory::find(const SearchStart& start) const {
  for (const Entry& entry : entries_)
    if (entry.start == start) return entry.result;
  return std::nullopt;
}

void SearchMemory::keep(const SearchStart& start, const SearchResult& result) {
  if (file_.path().empty()) return;
  entries_.push_back({start, result});
  if (file_.write(content())) stored_ = entries_.size();
}

json SearchMemory::content() const {
  json searches = json::array();
  for (const Entry& entry : entries_) {
    json stored = {{"base", json::array()},
                   {"least_gain", entry.start.leastGain},
                   {"lost_before", entry.start.lostCycles},
                   {"found", json::array()},
                   {"lost", entry.result.lostCycles}};
    for (const Cause& cause : entry.start.base) stored["base"].push_back(jsonOf(cause));
    for (const FittedCause& c : entry.result.candidates)
      stored["found"].push_back({jsonOf(c.cause), c.fit.fitting, c.fit.judging});
    searches.push_back(std::move(stored));
  }
  return searches;
}

void SearchMemory::forget() {
  file_.forget();
  entries_.clear();
  stored_ = 0;
}

}  // namespace plumbline::gap
