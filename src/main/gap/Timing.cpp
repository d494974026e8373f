#include "main/gap/Timing.h"

#include <ctime>

#include "framework/WriteFile.h"

namespace plumbline::gap {

void addTiming(CommandLine& command, std::string& file) {
  command.option("--timing", file, "Write the time that it took to this file, as JSON [s]");
}

void Timing::write(const std::string& file) const {
  if (file.empty()) return;
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin_).count();
  char text[100];
  std::snprintf(text, sizeof text, "{\"seconds\": %.1f, \"cpu_seconds\": %.1f}\n", seconds,
                static_cast<double>(std::clock()) / CLOCKS_PER_SEC);
  writeFile(file, text);
}

}  // namespace plumbline::gap
