#pragma once
#include <deque>
#include <map>
#include <string>
#include <vector>

#include "History.h"
#include "PlotWindow.h"
#include "Session.h"
#include "framework/StopSignal.h"

namespace plumbline::rdb {

/// The console in a terminal: watched values at the top, plots, answers, and an input line.
class Console {
public:
  Console(Link& link, Session& session, History& history, const StopSignal& stop);
  ~Console();
  Console(const Console&) = delete;
  Console& operator=(const Console&) = delete;

  /// Until the person ends it. Throws std::runtime_error where there is no terminal.
  void run();

private:
  struct Watch {
    int tag;
    std::string name, value;
  };

  void keepConnected();
  void key(int pressed);
  void enter();
  void submit(const std::string& line);
  bool local(const std::vector<std::string>& words, const std::string& line);
  void watch(const std::vector<std::string>& words, const std::string& line);
  void unwatch(const std::string& name);
  void showWindows();
  void png(const std::vector<std::string>& words);
  void begin(const std::string& script);
  void runScript();
  void askCommands();
  void complete();
  std::vector<std::string> completions(const std::vector<std::string>& words) const;
  void completed(const std::string& word, const std::vector<std::string>& found, bool parts);
  void print(const std::string& line);
  void browse(int direction);
  void draw();
  void putLine(int row, const std::string& text, bool bold = false);

  Link& link_;
  Session& session_;
  History& history_;
  const StopSignal& stop_;
  void* screen_ = nullptr;
  bool unicode_ = false, changed_ = true, ends_ = false, wasConnected_ = false, announced_ = false;
  double nextTry_ = 0;
  std::string input_, typed_;  ///< typed_: what stood there before the history was browsed
  std::size_t cursor_ = 0, place_ = 0, scroll_ = 0;
  std::vector<Watch> watches_;
  std::map<std::string, PlotWindow> windows_;  ///< of the plots, where there is a display
  std::deque<std::string> output_;
  std::vector<std::string> commands_;  ///< the agent's, by their words
  std::deque<std::string> script_;     ///< lines that are still to run
  double scriptWaits_ = 0;             ///< until then
  int asked_ = 0;                      ///< the last command that waits for its answer; 0: none does
};

}  // namespace plumbline::rdb
