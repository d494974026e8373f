#include "gap/diagnosis/Explanation.h"

#include <cstdio>

namespace plumbline::gap {

std::string describe(const Cause& cause) {
  char number[32];
  std::snprintf(number, sizeof number, "%.3g", cause.value);
  std::string text = std::string(cause.effect->id) + " at " + cause.place.at;
  if (cause.place.axis) text += std::string(" about ") + cause.place.axis;
  text += std::string(" = ") + number;
  if (cause.effect->unit != "1") text += " " + std::string(cause.effect->unit);
  return text;
}

Plant plantOf(const Mechanism& mechanism, const Explanation& causes) {
  Plant plant = nominalPlant(mechanism);
  for (const Cause& cause : causes) cause.effect->apply(plant, cause.place, cause.value, cause.variant);
  return plant;
}

}  // namespace plumbline::gap
