#pragma once
#include <map>
#include <string>

#include "gap/diagnosis/MemoryFile.h"
#include "gap/inference/Beam.h"

namespace plumbline::gap {

/// What one search came to, and how many replays it asked for.
struct StoredSearch {
  BeamResult found;  ///< of its fits only the causes are kept
  std::size_t replays = 0;
};

/// The same of one fit of values.
struct StoredValues {
  Explanation causes;
  std::size_t replays = 0;
};

/// Stores the searches of infer() and its fits of values by their names in a file, so that a stopped
/// diagnosis can continue and give the same bytes. Numbers are stored to the last bit.
class InferenceMemory {
public:
  /// path: read if it exists and is of this mark (InferenceMark.h), written after each part; empty: no file.
  /// warn: see MemoryFile.
  InferenceMemory(std::string path, std::string mark, const Mechanism& robot, MemoryFile::Warn warn = {});

  /// Null: not stored, or not of so many groups.
  const StoredSearch* search(const std::string& name, std::size_t groups) const;
  const StoredValues* values(const std::string& name) const;
  void keep(const std::string& name, StoredSearch search);
  void keep(const std::string& name, StoredValues values);

  /// Searches and fits that are in the file.
  std::size_t size() const { return stored_; }
  std::string sizeText() const;  ///< "3 searches done"
  const std::string& file() const { return file_.path(); }
  /// Removes the file: the diagnosis is done.
  void forget();

private:
  void take(const nlohmann::json& content, const Mechanism& robot);
  void write();

  MemoryFile file_;
  std::map<std::string, StoredSearch> searches_;
  std::map<std::string, StoredValues> values_;
  std::size_t stored_ = 0;
};

}  // namespace plumbline::gap
