#pragma once
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gap/diagnosis/ValueFit.h"

namespace plumbline::gap {

/// What a search starts from: all that its result depends on beside the evidence and the program.
struct SearchStart {
  Explanation base;
  double leastGain = 0;
  std::vector<std::vector<std::uint8_t>> lostCycles;  ///< that the base is played with; of one with dropout
  bool operator==(const SearchStart&) const = default;
};

/// What one search found: the candidates, and the lost cycles that go with them.
struct SearchResult {
  std::vector<Candidate> candidates;  ///< of their fits only the sums are kept
  std::vector<std::vector<std::uint8_t>> lostCycles;
};

/// Remembers searches in a file, so that a diagnosis that was stopped goes on where it was, to the same
/// bytes. The file belongs to what its mark stands for (EvidenceMark.h): one of other recordings, another
/// robot, other options or another version of the program is not taken.
class SearchMemory {
public:
  using Warn = std::function<void(const std::string&)>;

  /// path: read if it is there and fits, written after each search; empty: nothing is remembered. warn is
  /// told once where the file cannot be written; the diagnosis goes on then, remembered only while it runs.
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
