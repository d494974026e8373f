#include "Batch.h"

#include <clocale>
#include <cstdio>
#include <stdexcept>

#include <langinfo.h>

#include <cstring>

#include "framework/FileLines.h"
#include "framework/SteadyClock.h"

namespace plumbline::rdb {
namespace {

constexpr double forEver = 1e18, step = 0.2;

}  // namespace

Batch::Batch(Link& link, Session& session, const StopSignal& stop, Options options)
    : link_(link), session_(session), stop_(stop), options_(std::move(options)) {
  session_.other = [this](const std::string& line) {
    if (line.starts_with("error: ") && error_.empty()) error_ = line.substr(7);
  };
}

void Batch::receive(double seconds) {
  session_.receive(seconds);
  std::fflush(stdout);
  if (!link_.connected() && !stop_.requested())
    throw std::runtime_error(error_.empty() ? link_.name() + " has closed the connection" : error_);
}

void Batch::receiveFor(double seconds) {
  for (const double end = steadySeconds() + seconds; steadySeconds() < end && !stop_.requested();)
    receive(std::min(step, std::max(0.001, end - steadySeconds())));
}

void Batch::follow() {
  const double end = options_.seconds > 0 ? steadySeconds() + options_.seconds : forEver;
  while (lasting_ > 0 && !stop_.requested() && steadySeconds() < end)
    receive(std::min(step, end - steadySeconds()));
}

void Batch::run(const std::string& typed, const std::string& place) {
  const std::string line = session_.expand(typed);
  const auto words = wordsOf(line);
  if (words.empty()) return;
  try {
    if (words[0] == "sleep") return receiveFor(sleepSeconds(words));
    if (words[0] == "plot") {
      session_.plot(words, [this](const std::string& why) { error_ = why; });
      return;
    }
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(place + error.what());
  }
  const bool lasts = words[0] == "watch" || (words[0] == "dr" && words.size() == 2);
  bool done = false;
  std::string failed;
  const auto print = [&failed](const std::string& text) {
    if (text.starts_with("error: ")) {
      failed = text.substr(7);
      return;
    }
    // "ok" of an order says nothing that the exit status does not.
    if (text != "ok") std::printf("%s\n", text.c_str());
  };
  // What goes on behind this call only prints.
  const auto printLater = [](const std::string& text) {
    if (text != "ok") std::printf("%s\n", text.c_str());
  };
  bool answered = false;
  auto state = std::make_shared<bool>(true);
  session_.ask(line, {[&, state, print, printLater](const std::string& text) {
                        if (!*state) return printLater(text);
                        answered = true;
                        print(text);
                      },
                      [this, &done, state, lasts](bool) {
                        if (*state)
                          done = true;
                        else if (lasts)
                          --lasting_;
                      }});
  const double end = lasts && options_.seconds > 0 ? steadySeconds() + options_.seconds : forEver;
  while (!done && !stop_.requested() && steadySeconds() < end && !(lasts && answered)) receive(step);
  *state = false;
  if (!done && !lasts && stop_.requested()) throw Stopped("stopped before the answer came");
  if (lasts && !done) ++lasting_;
  if (!failed.empty()) throw std::runtime_error(place + failed);
}

bool Batch::runFile(const std::string& path) {
  FileLines in(path);
  int number = 0;
  for (std::string line; in.next(line) && !stop_.requested();) {
    ++number;
    if (line.empty() || line[0] == '#') continue;
    run(line, path + ':' + std::to_string(number) + ": ");
  }
  return !stop_.requested();
}

void Batch::showPlots() {
  if (session_.plots().empty()) return;
  const double end = options_.seconds > 0 ? steadySeconds() + options_.seconds : forEver;
  const auto full = [&] {
    for (const auto& [name, plot] : session_.plots()) {
      if (!plot.full()) return false;
    }
    return true;
  };
  while (!full() && error_.empty() && !stop_.requested() && steadySeconds() < end) receive(step);
  if (!error_.empty()) throw std::runtime_error(error_);
  const bool unicode = std::strcmp(nl_langinfo(CODESET), "UTF-8") == 0;
  for (const auto& [name, plot] : session_.plots()) {
    for (const std::string& line : plot.sparklines(60, unicode)) std::printf("%s\n", line.c_str());
  }
  if (options_.png.empty()) return;
  if (session_.plots().size() > 1)
    throw std::runtime_error("--png draws one window; give the values the name of one: plot VALUE WINDOW");
  session_.plots().begin()->second.writePng(options_.png, session_.plots().begin()->first);
}

}  // namespace plumbline::rdb
