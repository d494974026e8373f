#pragma once
#include <fmt/format.h>

#include <atomic>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace plumbline::bench {

/// Plays all tries, several at a time, each job in a game of its own: play(game, i) is the result of try i.
/// `what` are they, in the lines that tell how far it is. Throws std::runtime_error, one line, with the last
/// problem.
template <class Game, class Options, class Play>
auto playAll(const std::string& name, const char* what, const Options& options, int tries, int jobs,
             std::uint64_t seed, Play play) {
  constexpr int tellEvery = 20;
  std::vector<decltype(play(std::declval<Game&>(), 0))> results(static_cast<std::size_t>(tries));
  std::atomic<int> done{0};
  std::mutex mutex;
  std::string problem;
  const auto work = [&](int job) {
    try {
      Options own = options;
      own.scratch += fmt::format("/{}{}", name, job);
      std::filesystem::create_directories(own.scratch);
      Game game(own, seed + static_cast<std::uint64_t>(job));
      for (int i = job; i < tries; i += jobs) {
        results[static_cast<std::size_t>(i)] = play(game, i);
        const int now = ++done;
        const std::lock_guard lock(mutex);
        if (!problem.empty()) return;
        if (now % tellEvery == 0 || now == tries) fmt::print("{}: {} of {} {}\n", name, now, tries, what);
        std::fflush(stdout);
      }
    } catch (const std::exception& error) {
      const std::lock_guard lock(mutex);
      problem = error.what();
    }
  };
  std::vector<std::thread> threads;
  for (int job = 0; job < jobs; ++job) threads.emplace_back(work, job);
  for (std::thread& thread : threads) thread.join();
  if (!problem.empty()) throw std::runtime_error(problem);
  return results;
}

}  // namespace plumbline::bench
