#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

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
  std::vector<Candidate> candidates;  ///< of their fits only the sums are kept
  std::vector<std::vector<std::uint8_t>> lostCycles;
};

/// Stores searches in a file, so that a stopped diagnosis can continue and give the same bytes. The file is
/// used only if its mark (EvidenceMark.h) fits: not for other recordings, another robot, other options or
/// another version of the program.
class SearchMemory {
public:
  using Warn = std::function<void(const std::string&)>;

  /// path: read if it exists and fits, written after each search; empty: no file. warn is called once if the
  /// file cannot be written; the diagnosis then continues without it.
  SearchMemory(std::string path, std::string mark, const Mechanism& mechanism, Warn warn = {});

  std::optional<SearchResult> find(const SearchStart& start) const;
  void keep(const SearchStart& start, const SearchResult& result);
  /// Searches that are in the file.
  std::size_t size() const { return stored_; }
  const std::string& file() const { return path_; }
  /// Removes the file: the diagnosis is done.
  void forget();

private:
  struct Entry {
    SearchStart start;
    SearchResult result;
  };
  void read(const Mechanism& mechanism);
  void write();

  std::string path_, mark_;
  Warn warn_;
  std::vector<Entry> entries_;
  std::size_t stored_ = 0;
  bool writable_ = true;
};

}  // namespace plumbline::gap
