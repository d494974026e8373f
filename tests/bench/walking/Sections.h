#pragma once
#include <functional>

#include "bench/walking/Diagram.h"
#include "bench/walking/Report.h"
#include "bench/walking/Subjects.h"

namespace plumbline::bench {

struct BenchSetup {
  int seeds = 10;
  double minutes = 10;  ///< of random requests per type and seed
  int tries = 100;      ///< of each push
  int jobs = 0;         ///< threads; 0: as many as cores
  std::vector<std::string> robots = subjectNames();
  std::string parts = "build/bench/walking-parts";  ///< where what takes long is kept
};

/// Calls measure(i, report, page) for i = 0 .. count-1 on the threads asked for; what they write comes in the
/// order of i, whatever their number.
void measureEach(std::size_t count, const BenchSetup& setup, Report& report, Page& page,
                 const std::function<void(std::size_t, Report&, Page&)>& measure);
/// The same for what draws no figures.
void measureEach(std::size_t count, const BenchSetup& setup, Report& report,
                 const std::function<void(std::size_t, Report&)>& measure);

/// The same for long measurements: a part that this program has already measured in this setup with this walk
/// of the robot is read from its file, so that a stopped benchmark continues.
struct LongPart {
  const Subject& robot;
  std::string what;
};
void measureLong(std::size_t count, const BenchSetup& setup, Report& report,
                 const std::function<LongPart(std::size_t)>& part,
                 const std::function<void(std::size_t, Report&)>& measure);

/// How fast and how safely every robot walks.
void measureSpeeds(const BenchSetup& setup, Report& report);
/// The thesis's tables 4.1 and 4.3 to 4.5, before and after the model's optimisation;
/// figures 4.13, 4.14, 4.18 and 4.24.
void measureThesisTables(const BenchSetup& setup, Report& report, Page& page);
/// The largest push survived, open against closed loop.
void measurePushes(const BenchSetup& setup, Report& report);
/// Velocity estimate against the truth, cost per cycle; figures 4.2, 4.3, 4.5, 4.6, 4.9, 4.10.
void measureEstimate(const BenchSetup& setup, Report& report, Page& page);

}  // namespace plumbline::bench
