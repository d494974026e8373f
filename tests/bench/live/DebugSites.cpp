// What the debug interface's macros cost while nobody looks, each in a loop that has something to do beside
// it.
#include <benchmark/benchmark.h>

#include <cmath>

#include "framework/DebugPoints.h"
#include "framework/DrawingSite.h"

namespace plumbline {
namespace {

/// The same work without a macro is taken off: `site` is what the macro adds.
template <typename Site>
void run(benchmark::State& state, Site&& site) {
  double value = 1;
  site(value);  // it is known from the first time on
  for (auto _ : state) {
    value += 1e-9;
    site(value);
    benchmark::DoNotOptimize(value);
  }
  state.counters["target"] = 5;
}

void nothing(benchmark::State& state) {
  run(state, [](double& value) { benchmark::DoNotOptimize(value); });
}
BENCHMARK(nothing)->Name("live.loop_without_a_site");

void output(benchmark::State& state) {
  run(state, [](double& value) { OUTPUT("bench:output", value); });
}
BENCHMARK(output)->Name("live.off_OUTPUT");

void outputByValue(benchmark::State& state) {
  run(state, [](double& value) { OUTPUT_BY_VALUE("bench:outputByValue", std::sqrt(value) * 2); });
}
BENCHMARK(outputByValue)->Name("live.off_OUTPUT_BY_VALUE");

void modify(benchmark::State& state) {
  run(state, [](double& value) { MODIFY("bench:modify", value); });
}
BENCHMARK(modify)->Name("live.off_MODIFY");

void response(benchmark::State& state) {
  run(state,
      [](double& value) { DEBUG_RESPONSE("bench:response", value = 0; DEBUG_RESPONSE_OUTPUT("ran")); });
}
BENCHMARK(response)->Name("live.off_DEBUG_RESPONSE");

void responseOnce(benchmark::State& state) {
  run(state, [](double& value) { DEBUG_RESPONSE_ONCE("bench:once", value = 0); });
}
BENCHMARK(responseOnce)->Name("live.off_DEBUG_RESPONSE_ONCE");

void drawing(benchmark::State& state) {
  run(state,
      [](double& value) { DEBUG_DRAWING("bench:drawing", drawing.point(Vec2(value, 0), colours::red)); });
}
BENCHMARK(drawing)->Name("live.off_DEBUG_DRAWING");

/// Twenty of them in a row, as a module may have; the time of all.
void twenty(benchmark::State& state) {
  run(state, [](double& value) {
#define FOUR(name)                  \
  OUTPUT("bench:" name "1", value); \
  MODIFY("bench:" name "2", value); \
  OUTPUT("bench:" name "3", value); \
  MODIFY("bench:" name "4", value);
    FOUR("a") FOUR("b") FOUR("c") FOUR("d") FOUR("e")
#undef FOUR
  });
  state.counters["target"] = 100;
}
BENCHMARK(twenty)->Name("live.off_twenty_sites");

/// Where somebody looks: the thread that passes it writes the value's text form.
struct Look final : DebugRequest {
  void serve(DebugValue& value) noexcept override { benchmark::DoNotOptimize(value.drawing()); }
};
void drawingOn(benchmark::State& state) {
  const auto look = std::make_shared<Look>();
  const auto site = [](double value) {
    DEBUG_DRAWING("bench:on", {
      for (int i = 0; i < 30; ++i) drawing.circle(Vec2(value, i), 0.1, colours::yellow);
    });
  };
  site(0);
  DebugPoints::sites().attach("bench:on", look);
  for (auto _ : state) site(1);
  DebugPoints::sites().detach("bench:on", look);
}
BENCHMARK(drawingOn)->Name("live.on_DEBUG_DRAWING_of_30_circles");

}  // namespace
}  // namespace plumbline
