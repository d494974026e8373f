// bin/simplemonitor: the field in a terminal (thesis A.6.3).
#include <poll.h>
#include <sys/ioctl.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <clocale>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <optional>
#include <stdexcept>

#include "FieldSource.h"
#include "Terminal.h"
#include "framework/CommandLine.h"
#include "framework/GuardedMain.h"
#include "framework/StopSignal.h"
#include "simspark/NumberFormat.h"
#include "simspark/StandardPorts.h"

namespace {

using namespace plumbline;
using simplemonitor::FieldSource;
using simplemonitor::Terminal;

constexpr int badInput = 2;

struct Options {
  std::string host = "localhost", token, size;
  int port = 0;  ///< 0: the compact port, else the monitor port
  bool once = false, ascii = false;
  double seconds = 0;  ///< 0: until it is ended
  int columns = 0, rows = 0;
};

double secondsOf(clockid_t clock) {
  timespec time{};
  clock_gettime(clock, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}
double wallClock() { return secondsOf(CLOCK_MONOTONIC); }

/// "HOST:PORT" and "COLUMNSxROWS" into their parts; throws std::runtime_error.
void complete(Options& options) {
  if (const auto colon = options.host.find(':');
      colon != std::string::npos && colon == options.host.rfind(':')) {
    const auto port = simspark::parseInteger(options.host.substr(colon + 1));
    if (!port || *port < 1 || *port > 65535)
      throw std::runtime_error(options.host + ": a port, 1 to 65535, must follow the colon");
    if (options.port != 0) throw std::runtime_error(options.host + " and --port name two ports");
    options.port = *port;
    options.host.resize(colon);
  }
  if (options.host.empty()) throw std::runtime_error("the host is empty");
  if (options.size.empty()) return;
  const auto cross = options.size.find('x');
  const auto columns = simspark::parseInteger(options.size.substr(0, cross));
  const auto rows =
      cross == std::string::npos ? std::nullopt : simspark::parseInteger(options.size.substr(cross + 1));
  if (!columns || !rows || *columns < watch::minPictureColumns || *rows < watch::minPictureRows ||
      *columns > 1000 || *rows > 1000)
    throw std::runtime_error("--size " + options.size + ": must be COLUMNSxROWS, from " +
                             std::to_string(watch::minPictureColumns) + 'x' +
                             std::to_string(watch::minPictureRows) + " to 1000x1000");
  options.columns = *columns;
  options.rows = *rows;
}

Stopped noPicture() { return Stopped("stopped before a picture came"); }

void printOnce(const Options& options, FieldSource& source, const StopSignal& stop) {
  constexpr double patience = 10;
  for (const double end = wallClock() + patience; !source.receive(0.1);) {
    if (stop.requested()) throw noPicture();
    if (!source.connected()) throw std::runtime_error(source.problem());
    if (wallClock() > end)
      throw std::runtime_error(source.name() + " sent nothing for 10 s: is the simulation stopped?");
  }
  winsize window{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &window) != 0 || window.ws_col == 0) window = {24, 80, 0, 0};
  const int columns = options.columns ? options.columns : window.ws_col;
  const int rows = options.rows ? options.rows : window.ws_row - 1;
  const watch::FieldPictureStyle style{!options.ascii && simplemonitor::localeIsUnicode(), false};
  const auto picture = watch::fieldPicture(source.state(), columns, rows, style, source.name());
  for (int row = 0; row < picture.rows(); ++row) std::puts(picture.row(row).c_str());
}

/// What comes in a second, over the last seconds.
class Rate {
public:
  double operator()(double now, std::size_t bytes) {
    if (now - since_ >= 3) {
      rate_ = since_ > 0 ? static_cast<double>(bytes - before_) / (now - since_) : 0;
      since_ = now;
      before_ = bytes;
    }
    return rate_;
  }

private:
  double since_ = 0, rate_ = 0;
  std::size_t before_ = 0;
};

/// Waits for keys, the stop, something new of the game, or the end of the time.
void wait(const FieldSource& source, const StopSignal& stop, double seconds) {
  std::array<pollfd, 3> descriptors{{{isatty(STDIN_FILENO) ? STDIN_FILENO : -1, POLLIN, 0},
                                     {stop.fileDescriptor(), POLLIN, 0},
                                     {source.descriptor(), POLLIN, 0}}};
  poll(descriptors.data(), descriptors.size(), std::max(1, static_cast<int>(seconds * 1000)));
}

void show(const Options& options, FieldSource& source, const StopSignal& stop) {
  constexpr double interval = simspark::fieldInterval, reconnectPause = 1;
  Terminal terminal(options.ascii);
  Rate rate;
  const double end = options.seconds > 0 ? wallClock() + options.seconds : 1e300;
  double nextPicture = 0, nextTry = 0;
  bool changed = true;
  while (!stop.requested() && wallClock() < end) {
    const double now = wallClock();
    if (!source.connected() && now >= nextTry) {
      source.connect();
      nextTry = now + reconnectPause;
      changed = true;
    }
    changed = source.receive(0) || changed;
    const Terminal::Key key = terminal.key();
    if (key == Terminal::Key::quit) return;
    if (key != Terminal::Key::none || (changed && now >= nextPicture) || !source.connected()) {
      const double kilobytes = rate(now, source.bytes()) / 1000;
      const std::string footer = source.name() + "   " + [&] {
        std::string text;
        simspark::appendFixed(text, kilobytes, 1);
        return text;
      }() + " kB/s   q: quit";
      const std::string problem = source.connected() ? (source.complete() ? "" : "waiting for the game")
                                                     : source.problem() + "; trying again";
      terminal.show(watch::fieldPicture(source.state(), terminal.columns(), terminal.rows(), terminal.style(),
                                        footer, problem));
      changed = false;
      nextPicture = now + 0.9 * interval;
    }
    wait(source, stop, std::min(end - now, changed ? nextPicture - now : source.connected() ? 1.0 : 0.2));
  }
}

void declare(CommandLine& app, Options& options) {
  app.option("host", options.host, "Where the simulator runs: HOST or HOST:PORT").showDefault();
  app.option("--port", options.port, "Its compact port or any SimSpark monitor port [3201, else 3200]")
      .port();
  app.option("--token", options.token, "The simulator's token, if it needs one");
  app.flag("--once", options.once, "Print one picture as text and end");
  app.option("--size", options.size,
             "With --once: size of the picture, COLUMNSxROWS [the terminal's or 80x23]");
  app.flag("--ascii", options.ascii, "ASCII characters only, whatever the locale");
  app.option("--seconds", options.seconds,
             "End after this time and print what was received and the time that it took")
      .range(0.1, 1e6);
  app.footer(
      "Numbers are robots with the way they look, x: fallen. Blue is the left team, red the right one.\n"
      "Keys: q ends, Ctrl-L draws anew.\n"
      "Examples:\n"
      "  bin/simplemonitor                                 a simulator on this machine\n"
      "  bin/simplemonitor 192.168.1.20                    one elsewhere\n"
      "  bin/simplemonitor server --port 3200              the league's, unpatched\n"
      "  ssh -L 3201:127.0.0.1:3201 server                 through a tunnel: then bin/simplemonitor\n"
      "  bin/simplemonitor --once --size 120x40            the picture as text");
}

int runProgram(int argc, char** argv) {
  Options options;
  CommandLine app("The field of a running simulation in a terminal.", "simplemonitor");
  declare(app, options);
  if (const auto status = readCommandLine(app, argc, argv)) return *status;
  try {
    complete(options);
    if (!options.size.empty() && !options.once) throw std::runtime_error("--size is for --once");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "simplemonitor: %s\n", commandLineError(app, error.what()).c_str());
    return badInput;
  }
  std::setlocale(LC_ALL, "");
  std::setlocale(LC_NUMERIC, "C");
  StopSignal stop;
  stop.catchSignals();
  FieldSource source(options.host,
                     options.port ? std::vector{options.port}
                                  : std::vector{simspark::standardFieldPort, simspark::standardMonitorPort},
                     options.token);
  source.interruptBy(stop.fileDescriptor());
  const double start = wallClock();
  if (const std::string why = source.connect(); !why.empty()) {
    if (stop.requested() && options.once) throw noPicture();
    if (stop.requested()) return 0;
    throw std::runtime_error(why + "; is a simulator running there?");
  }
  if (options.once) {
    printOnce(options, source, stop);
    return 0;
  }
  show(options, source, stop);
  if (options.seconds > 0) {
    const double wall = wallClock() - start;
    std::printf("simplemonitor: %.0f bytes/s for %.1f s, %.2f %% of a core\n",
                static_cast<double>(source.bytes()) / wall, wall,
                100 * secondsOf(CLOCK_PROCESS_CPUTIME_ID) / wall);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) { return plumbline::guardedMain("simplemonitor", runProgram, argc, argv); }
