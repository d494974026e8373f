#include "bench/walking/Sections.h"

#include "framework/Parallel.h"

namespace plumbline::bench {

void measureEach(std::size_t count, const BenchSetup& setup, Report& report, Page& page,
                 const std::function<void(std::size_t, Report&, Page&)>& measure) {
  std::vector<Report> reports(count);
  std::vector<Page> pages(count);
  parallel(count, threadsFor(setup.jobs), [&](std::size_t i) { measure(i, reports[i], pages[i]); });
  for (std::size_t i = 0; i < count; ++i) {
    report.append(reports[i]);
    page.figures.insert(page.figures.end(), pages[i].figures.begin(), pages[i].figures.end());
  }
}

void measureEach(std::size_t count, const BenchSetup& setup, Report& report,
                 const std::function<void(std::size_t, Report&)>& measure) {
  Page none;
  measureEach(count, setup, report, none, [&](std::size_t i, Report& part, Page&) { measure(i, part); });
}

}  // namespace plumbline::bench
