#pragma once
#include <ctime>
#include <string>

namespace plumbline::bench {

/// The date of a measurement, 2026-11-29, in UTC.
inline std::string today() {
  const std::time_t now = std::time(nullptr);
  char date[32];
  std::strftime(date, sizeof date, "%Y-%m-%d", std::gmtime(&now));
  return date;
}

}  // namespace plumbline::bench
