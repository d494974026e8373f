#pragma once
#include <cstdint>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <vector>

#include "optimization/Search.h"

namespace plumbline::farm {

/// A result as the file has it.
struct JournalEntry {
  std::int64_t number = 0;
  bool givenUp = false;
  std::vector<double> costs{};
};

/// Every result of a search, a line of JSON each, in a file that is a checkpoint as well: a search that gets
/// the same results again, in any order, is in the same state. A line is written before its result counts, so
/// a killed server loses only trials without an answer; an incomplete last line is dropped.
class Journal {
public:
  static constexpr std::size_t maxLine = std::size_t{1} << 20;

  /// Opens the file or begins it, and reads all entries there are. mark: all that decides what the results
  /// mean. Throws std::runtime_error, one line that says what to do: a file of another search, one that
  /// another server has open, one broken before its last line, a disk that does not take it.
  Journal(std::string path, const std::string& mark, const std::function<void(const JournalEntry&)>& entry);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// Without costs: given up.
  void add(const Trial& trial, std::span<const double> costs, const std::map<std::string, double>& figures,
           const std::string& worker, double seconds);
  /// Syncs to the disk, for a loss of power; entries survive a kill without it.
  void sync();
  const std::string& path() const { return path_; }
  std::int64_t resumed() const { return resumed_; }  ///< entries that were there

private:
  void read(const std::string& mark, const std::function<void(const JournalEntry&)>& entry);
  void write(const std::string& line);

  const std::string path_;
  int fd_ = -1;
  std::int64_t resumed_ = 0;
};

}  // namespace plumbline::farm
