#pragma once
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "Aliases.h"
#include "Link.h"
#include "Plot.h"

namespace plumbline::rdb {

/// Of the command `sleep SECONDS`; throws std::runtime_error for another form.
double sleepSeconds(const std::vector<std::string>& words);

/// Commands to an agent and their answers: each command has a tag that identifies its answer. Watched values
/// and plots are requested again after the connection was lost.
class Session {
public:
  struct Handler {
    std::function<void(const std::string& line)> line;
    /// The answer is complete; `lost`: it never will be.
    std::function<void(bool lost)> ended;
  };

  Session(Link& link, Aliases aliases) : link_(link), aliases_(std::move(aliases)) {}

  std::string expand(const std::string& line) const { return aliases_.expand(line); }
  /// A command of the agent, its aliases replaced before. Returns its tag.
  int ask(const std::string& command, Handler handler);
  /// A watch, which goes on until forget().
  int follow(const std::string& name, const std::string& interval, Handler handler);
  void forget(int tag);

  /// Takes what has come; waits at most so long for the first line.
  void receive(double seconds);
  /// The connection was lost: open answers end. Then, once it is there again, asks for what is followed.
  void lost();
  void resume();
  bool idle() const { return open_.empty(); }

  std::map<std::string, Plot>& plots() { return plots_; }
  /// `plot VALUE [WINDOW [COUNT [SECONDS]]]`. Throws std::runtime_error for another form. `failed` takes the
  /// agent's error. Returns the window's name.
  std::string plot(const std::vector<std::string>& words,
                   const std::function<void(const std::string&)>& failed);
  /// `plot off [WINDOW]`.
  void endPlots(const std::string& window);

  /// A line without a tag: a word of the agent itself.
  std::function<void(const std::string&)> other;

private:
  struct Open {
    std::string command;
    Handler handler;
    bool follows;
  };
  Link& link_;
  Aliases aliases_;
  std::map<int, Open> open_;
  std::map<std::string, Plot> plots_;
  std::map<int, std::string> plotOf_;
  int tags_ = 0;
};

/// The words of a line.
std::vector<std::string> wordsOf(const std::string& line);

}  // namespace plumbline::rdb
