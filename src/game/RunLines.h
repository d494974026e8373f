#pragma once
#include <string>
#include <vector>

namespace plumbline::game {

/// What an agent said of itself and when [s of the game].
struct StatusWords {
  double time = 0;
  std::string words;
};

/// The printed lines of a run. The outputs of simulator and agent are read separately, so a line waits until
/// the agent's part must be complete. The order in which the two are read has no effect.
class RunLines {
public:
  struct Line {
    double time = 0;    ///< of the game [s]
    std::string scene;  ///< positions of everything, without the words
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
