#pragma once
#include <optional>
#include <string>
#include <vector>

#include "gap/diagnosis/ValueFit.h"

namespace plumbline::gap {

/// What one search found: the candidates, and the lost cycles that go with them.
struct SearchResult {
  std::vector<Candidate> candidates;  ///< of their fits only the sums are kept
  std::vector<std::vector<std::uint8_t>> lostCycles;
};

/// Remembers searches in a file, so that a diagnosis that was stopped goes on where it was. The file belongs
/// to the evidence it was made from: one of other runs, another robot or another library is not taken.
class SearchMemory {
public:
  /// path: read if it is there and fits, written after each search; empty: nothing is remembered.
  SearchMemory(std::string path, const Evaluator& evaluator);

  std::optional<SearchResult> find(const Explanation& base) const;
  /// Throws std::runtime_error where the file cannot be written.
  void keep(const Explanation& base, const SearchResult& result);
  std::size_t size() const { return entries.size(); }
  /// Removes the file: the diagnosis is done.
  void forget();

private:
  struct Entry {
    Explanation base;
    SearchResult result;
  };
  void read(const Mechanism& mechanism);
  void write() const;

  std::string path, mark;  ///< mark: of the evidence
  std::vector<Entry> entries;
};

}  // namespace plumbline::gap
