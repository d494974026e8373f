#pragma once
#include <sys/types.h>

#include <string>

namespace plumbline::rdb {

class Plot;

/// A plot in its own window on the display, drawn by gnuplot in a separate process. Nobody waits for it: a
/// picture that it does not accept in time is left out.
class PlotWindow {
public:
  /// True where there is a display (DISPLAY or WAYLAND_DISPLAY is set).
  static bool possible();

  explicit PlotWindow(const std::string& title);
  ~PlotWindow();
  PlotWindow(const PlotWindow&) = delete;
  PlotWindow& operator=(const PlotWindow&) = delete;

  /// The plot as it is now, at most as often as it says itself.
  void show(const Plot& plot);
  /// "", or once in one line why there is no window; from then on nothing is shown.
  std::string problem();

private:
  void send();
  void end(const std::string& why);

  std::string title_, unsent_, problem_;
  pid_t child_ = -1;
  int socket_ = -1;
  double next_ = 0;
};

}  // namespace plumbline::rdb
