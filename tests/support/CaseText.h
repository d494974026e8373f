#pragma once
#include <cstdio>
#include <string>

#include "gap/blind/BlindScore.h"

namespace plumbline::bench {

/// For a page: an effect at its place with its value.
inline std::string nameOfOne(const std::string& effect, const std::string& at, const std::string& axis,
                             double value) {
  char number[32];
  std::snprintf(number, sizeof number, "%.3g", value);
  return effect + " at " + (at == "*" ? "all joints" : at) + (axis.empty() ? "" : " " + axis) + " " + number;
}

/// What a case hides, "nothing" where that is so.
inline std::string hidden(const gap::BlindCase& c) {
  std::string text;
  for (const gap::BlindEffect& e : c.effects)
    text += (text.empty() ? "" : ", ") + nameOfOne(e.effect, e.at, e.axis, e.value);
  return text.empty() ? "nothing" : text;
}

}  // namespace plumbline::bench
