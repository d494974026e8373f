#pragma once
#include <functional>
#include <string>
#include <vector>

#include "walking/parameters/WalkGaits.h"

namespace plumbline::training {

/// The state of a search for a walk, in a file, so that it can be stopped at any moment and continue to the
/// same bytes. The search is a sequence of stages, each of which gives a walk. Finished stages are read back,
/// bit for bit, and the interrupted one restores its optimiser's state.
///
///     gaits = checkpoint.stage([&] { return train(gaits, setup, progress); });
class WalkCheckpoint {
public:
  /// Reads the file if it is there. mark: all that decides what is found (options, files, program); a file
  /// with another mark, or a damaged one, is a ConfigurationError that says what to do.
  WalkCheckpoint(std::string file, std::string mark);

  /// What the next stage gave when it was done before, or what it gives now, which is then stored.
  walking::WalkGaits stage(const std::function<walking::WalkGaits()>& work);

  /// The state of the optimiser within the running stage; empty: it begins anew. Storing it writes the file,
  /// at most about once a second.
  const std::string& search() const { return search_; }
  void storeSearch(const std::string& state);

  bool resumed() const { return resumed_; }
  const std::string& file() const { return file_; }
  /// The work is done: removes the file.
  void forget();

private:
  void read();
  void write();

  const std::string file_, mark_;
  std::vector<walking::WalkGaits> done_;
  std::size_t next_ = 0;
  std::string search_;
  double written_ = 0;
  bool resumed_ = false;
};

/// All of a walk's numbers, bit for bit, and back; the second throws std::invalid_argument for what is no
/// such text.
std::string exactText(const walking::WalkGaits& gaits);
walking::WalkGaits walkOfExactText(const std::string& text);

}  // namespace plumbline::training
