#pragma once
#include <optional>
#include <string>
#include <vector>

#include "gap/diagnosis/MemoryFile.h"
#include "gap/diagnosis/ValueFit.h"

namespace plumbline::gap {

/// Start of a search: everything on which its result depends, besides the evidence and the program.
struct SearchStart {
  Explanation base;
  double leastGain = 0;
  std::vector<std::vector<std::uint8_t>> lostCycles;  ///< with which a base with dropout is replayed
  bool operator==(const SearchStart&) const = default;
};

/// Result of one search: the candidates and their lost cycles.
struct SearchResult {
  std::vector<FittedCause> candidates;  ///< of their fits only the sums are kept
  std::vector<std::vector<std::uint8_t>> lostCycles;
};

/// Stores searches in a file, so that a stopped diagnosis can continue and give the same bytes. The file is
/// used only if its mark (EvidenceMark.h) fits: not for other recordings, another robot, other options or
/// another version of the program.
class SearchMemory {
public:
  /// path: read if it exists and fits, written after each search; empty: no file. warn is called where the
  /// file cannot be used, and once if it cannot be written; the diagnosis then continues without it.
  SearchMemory(std::string path, std::string mark, const Mechanism& mechanism, MemoryFile::Warn warn = {});

  std::optional<SearchResult> find(const SearchStart& start) const;
  void keep(const SearchStart& start, const SearchResult& result);
  /// Searches that are in the file.
  std::size_t size() const { return stored_; }
  const std::string& file() const { return file_.path(); }
  /// Removes the file: the diagnosis is done.
  void forget();

private:
  struct Entry {
    SearchStart start;
    SearchResult result;
  };
  void take(const nlohmann::json& searches, const Mechanism& mechanism);
  nlohmann::json content() const;

  MemoryFile file_;
  std::vector<Entry> entries_;
  std::size_t stored_ = 0;
};

}  // namespace plumbline::gap
