#pragma once
#include <string>
#include <vector>

namespace plumbline::game {

/// What an agent said of itself and when [s of the game].
struct StatusWords {
  double time = 0;
  std::string words;
};

/// The printed lines of a run. Simulator and agent are read apart, so a line waits until the agent must have
/// said all that belongs to it: which of two programs was read first decides nothing.
class RunLines {
public:
  struct Line {
    double time = 0;    ///< of the game [s]
    std::string scene;  ///< how everything stands, without the words
    bool fallen = false, goal = false;
  };

  void add(Line line) { waiting_.push_back(std::move(line)); }
  /// Lines that are due at a time of the game, complete with newlines; `said` in the order of time.
  std::string due(double now, const std::vector<StatusWords>& said);
  /// All that are left when the run ends at this time.
  std::string rest(double end, const std::vector<StatusWords>& said);

private:
  std::vector<Line> waiting_;
};

}  // namespace plumbline::game
