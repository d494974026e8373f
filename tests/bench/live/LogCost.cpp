// What a log costs the agent's thread, for all that a robot of the league knows in a cycle of a game, and the
// thread that writes it. Beside it a bare stream of the same bytes.
#include <benchmark/benchmark.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "framework/Controller.h"
#include "framework/Registry.h"
#include "modules/infrastructure/LogModule.h"
#include "record/LogReader.h"
#include "record/LogWalk.h"
#include "record/LogWriter.h"
#include "record/ReplayConfig.h"
#include "record/ThreadRecorder.h"

namespace plumbline::record {
namespace {

namespace fs = std::filesystem;

/// Ten seconds of a game, recorded now.
class Game {
public:
  Game() : folder_(fs::temp_directory_path() / ("bench-log-" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
    const std::string at = folder_.string();
    const std::string command = "bin/game --seed 8 --limit 10 --output " + at +
                                "/out --agent-option=--log --agent-option=" + at +
                                "/game --agent-option=--log-wait > " + at + "/printed 2>&1";
    if (std::system(command.c_str()) == -1) throw std::runtime_error("bin/game cannot be started");
    LogReader log(at + "/game");
    thread = log.thread("").recorded;
    LogWalk walk(log);
    LogWalk::Step step{};
    while (walk.next(step)) cycles.push_back(*step.messages);
  }
  ~Game() { fs::remove_all(folder_); }
  std::string operator/(const std::string& name) const { return (folder_ / name).string(); }

  RecordedThread thread;
  std::vector<std::vector<std::string>> cycles;  ///< messages of each topic

private:
  fs::path folder_;
};

const Game& game() {
  static const Game one;
  return one;
}

/// All representations as they were in the middle of the game.
struct Values {
  std::vector<std::unique_ptr<RepresentationHolder>> holders;
  std::vector<Representation*> all;

  Values() {
    const auto& messages = game().cycles.at(game().cycles.size() / 2);
    for (std::size_t i = 0; i < messages.size(); ++i) {
      const auto* loader = Registry::instance().representations().at(game().thread.topics[i].representation);
      holders.push_back(loader->create());
      CdrInStream in(messages[i]);
      holders.back()->get().stream(&in, nullptr);
      all.push_back(&holders.back()->get());
    }
  }
};

void agentsThread(benchmark::State& state) {
  Values values;
  ThreadRecorder recorder(game().thread, values.all, std::size_t{32} << 20, false);
  CycleView view;
  std::int64_t timestamp = 0;
  for (auto _ : state) {
    recorder.record(timestamp += 20'000'000);
    if (timestamp / 20'000'000 % 1000 == 0) {
      state.PauseTiming();
      while (recorder.take(view)) benchmark::DoNotOptimize(view.number);
      state.ResumeTiming();
    }
  }
  if (recorder.dropped() > 0) state.SkipWithError("cycles were dropped");
  state.counters["target"] = 20000;  // [ns]
}
BENCHMARK(agentsThread)->Name("live.log_cycle_of_all_representations");

double bareStream() {
  const std::string path = game() / "bare";
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) return 0;
  const auto begin = std::clock();
  std::vector<std::string> last(game().thread.topics.size());
  for (const auto& messages : game().cycles) {
    for (std::size_t i = 0; i < messages.size(); ++i) {
      if (messages[i] == last[i]) continue;
      const std::uint64_t head[] = {i, messages[i].size()};
      std::fwrite(head, sizeof(head), 1, file);
      std::fwrite(messages[i].data(), messages[i].size(), 1, file);
      last[i] = messages[i];
    }
  }
  std::fclose(file);
  const double taken = 1e9 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return taken / static_cast<double>(game().cycles.size());
}

void writersThread(benchmark::State& state) {
  const double bare = bareStream();
  static int run = 0;  // a benchmark is run several times, a log never overwritten
  std::unique_ptr<LogWriter> writer;
  std::size_t at = 0;
  std::uint64_t number = 0;
  CycleView view;
  for (auto _ : state) {
    if (!writer || at == game().cycles.size()) {
      state.PauseTiming();
      writer = std::make_unique<LogWriter>(game() / ("log" + std::to_string(run++)), LogWriterOptions{});
      writer->begin({game().thread});
      at = 0;
      state.ResumeTiming();
    }
    view.number = ++number;
    view.timestamp = static_cast<std::int64_t>(number) * 20'000'000;
    view.messages.assign(game().cycles[at].begin(), game().cycles[at].end());
    writer->write(view);
    if (at++ % 12 == 0) writer->commit();  // a quarter of a second
  }
  state.counters["peer_value"] = bare;
}
BENCHMARK(writersThread)->Name("live.log_writer_cycle_beside_bare_stream");

}  // namespace
}  // namespace plumbline::record
