#include <benchmark/benchmark.h>

#include <array>
#include <atomic>
#include <thread>

#include "framework/BinaryStream.h"
#include "framework/Controller.h"
#include "framework/DebugSite.h"
#include "framework/Process.h"
#include "framework/TextStream.h"
#include "framework/ThreadCopy.h"

namespace plumbline {

REPRESENTATION(OneKilobyte)
class OneKilobyte : public OneKilobyteBase {
public:
  std::array<double, 127> values{};
};
static_assert(sizeof(OneKilobyte) == 1024);

// Templates do not go through the macros: this is what they expand to, once for many numbers.
template <int n>
class Numbered : public RepresentationOf<Numbered<n>> {
public:
  static const char* representationName() {
    static const std::string name = "Representation" + std::to_string(n);
    return name.c_str();
  }
  double value = 0;
};

/// Provides Numbered<n>, and every second one also Numbered<100 + n / 2>; requires what the module before and
/// the one ten before provide.
template <int n>
class NumberedModule : public Module {
public:
  static ModuleDescription& moduleDescription() {
    static ModuleDescription description(("Module" + std::to_string(n)).c_str(), "");
    static const bool filled = [] {
      ModuleDescription& d = description;
      if constexpr (n >= 1) d.add(Numbered<n - 1>::representationName(), ModuleInput::Kind::required, bind);
      if constexpr (n >= 10) d.add(Numbered<n - 10>::representationName(), ModuleInput::Kind::required, bind);
      d.add(representationLoader<Numbered<n>>(), update);
      if constexpr (n % 2 == 0) d.add(representationLoader<Numbered<100 + n / 2>>(), update);
      return true;
    }();
    benchmark::DoNotOptimize(filled);
    return description;
  }

private:
  static void bind(Module&, const Representation*) {}
  static void update(Module& module, Representation& value) {
    static_cast<NumberedModule&>(module).updateValue(&value);
  }
  virtual void updateValue(Representation* value) { benchmark::DoNotOptimize(value); }
};

template <int... n>
void registerModules(std::integer_sequence<int, n...>) {
  (static_cast<void>(new ModuleLoaderOf<NumberedModule<n>>), ...);
}

/// Lines in the worst order: each module stands before those it requires.
std::string reversedLines(int modules, bool second) {
  static const bool registered = (registerModules(std::make_integer_sequence<int, 100>()), true);
  benchmark::DoNotOptimize(registered);
  std::string text;
  for (int n = modules - 1; n >= 0; --n) {
    const std::string module = "Module" + std::to_string(n);
    text += module + " Representation" + std::to_string(n) + "\n";
    if (second && n % 2 == 0) text += module + " Representation" + std::to_string(100 + n / 2) + "\n";
  }
  return text;
}

void loadAndSort(benchmark::State& state) {
  const std::string text = reversedLines(100, true);
  for (auto _ : state) {
    Controller controller({"modules.cfg", {"nowhere"}}, text);
    controller.init();
    benchmark::DoNotOptimize(controller.findRepresentation("Representation149"));
  }
  state.counters["target"] = 5;
}
BENCHMARK(loadAndSort)->Name("framework.load_100_modules_150_representations")->Unit(benchmark::kMillisecond);

/// One execute and one update with their stopwatches, in a cycle of 100 modules.
void emptyModule(benchmark::State& state) {
  Controller controller({"modules.cfg", {"nowhere"}}, reversedLines(100, false));
  controller.init();
  while (state.KeepRunningBatch(100)) controller.runCycles(1);
  state.counters["target"] = 150;
}
BENCHMARK(emptyModule)->Name("framework.empty_module");

/// What a cycle costs around its modules: a single empty module.
void emptyCycle(benchmark::State& state) {
  Controller controller({"modules.cfg", {"nowhere"}}, reversedLines(1, false));
  controller.init();
  for (auto _ : state) controller.runCycles(1);
}
BENCHMARK(emptyCycle)->Name("framework.cycle_of_one_module");

/// Both sides of a copy, one after the other.
void threadCopy(benchmark::State& state) {
  OneKilobyte source, target;
  ThreadCopy copy;
  copy.add(representationLoader<OneKilobyte>(), source, target);
  for (auto _ : state) {
    copy.publish();
    copy.fetch();
    benchmark::DoNotOptimize(target.values);
  }
  state.counters["target"] = 300;
}
BENCHMARK(threadCopy)->Name("framework.thread_copy_1kB");

/// Publishing while another thread fetches as fast as it can, and the other way round.
void threadCopyBusy(benchmark::State& state, bool measurePublish) {
  OneKilobyte source, target;
  ThreadCopy copy;
  copy.add(representationLoader<OneKilobyte>(), source, target);
  std::atomic<bool> end{false};
  std::thread other([&] {
    while (!end) measurePublish ? static_cast<void>(copy.fetch()) : copy.publish();
  });
  for (auto _ : state) measurePublish ? copy.publish() : static_cast<void>(copy.fetch());
  end = true;
  other.join();
  state.counters["target"] = 300;
}
BENCHMARK_CAPTURE(threadCopyBusy, publish, true)->Name("framework.thread_copy_1kB_publish_busy");
BENCHMARK_CAPTURE(threadCopyBusy, fetch, false)->Name("framework.thread_copy_1kB_fetch_busy");

REPRESENTATION(Numbers)
class Numbers : public NumbersBase {
public:
  std::array<double, 128> values{};
  void stream(InStream* in, OutStream* out) override { STREAM(values); }
};

void binaryStream(benchmark::State& state) {
  Numbers numbers, back;
  for (auto _ : state) {
    const std::string bytes = toBinary(numbers);
    benchmark::DoNotOptimize(fromBinary(bytes, back));
  }
}
BENCHMARK(binaryStream)->Name("framework.binary_stream_1kB_round_trip");

/// What a site of the debug interface costs while nobody looks.
void debugSiteOff(benchmark::State& state) {
  double value = 1;
  for (auto _ : state) {
    MODIFY("bench:off", value);
    benchmark::DoNotOptimize(value);
  }
}
BENCHMARK(debugSiteOff)->Name("framework.debug_site_off");

void textStream(benchmark::State& state) {
  Numbers numbers, back;
  for (auto& value : numbers.values) value = 1.0 / 3 + static_cast<double>(&value - numbers.values.data());
  for (auto _ : state) {
    const std::string text = toText(numbers);
    benchmark::DoNotOptimize(fromText(text, back));
  }
}
BENCHMARK(textStream)->Name("framework.text_stream_128_numbers_round_trip");

}  // namespace plumbline
