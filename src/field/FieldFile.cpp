#include "field/FieldFile.h"

#include "framework/ConfigFile.h"
#include "framework/ModuleParameters.h"
#include "framework/ParameterFiles.h"

namespace plumbline {

MAKE_PARAMETER_FILE("field", FieldSize, "The sizes of the field, also of a file of `--field`.")

namespace {

/// `factor` (1 or 2) times one size is at most another one.
struct Limit {
  const char* small;
  double FieldSize::*smallSize;
  int factor;
  const char* large;
  double FieldSize::*largeSize;
};

constexpr Limit limits[] = {
    {"penaltyWidth", &FieldSize::penaltyWidth, 1, "width", &FieldSize::width},
    {"goalWidth", &FieldSize::goalWidth, 1, "penaltyWidth", &FieldSize::penaltyWidth},
    {"penaltyDepth", &FieldSize::penaltyDepth, 2, "length", &FieldSize::length},
    {"centreCircleRadius", &FieldSize::centreCircleRadius, 2, "width", &FieldSize::width},
    {"centreCircleRadius", &FieldSize::centreCircleRadius, 2, "length", &FieldSize::length},
    {"ballRadius", &FieldSize::ballRadius, 2, "goalWidth", &FieldSize::goalWidth},
    {"ballRadius", &FieldSize::ballRadius, 2, "goalDepth", &FieldSize::goalDepth},
    {"ballRadius", &FieldSize::ballRadius, 2, "goalHeight", &FieldSize::goalHeight}};

/// Names the size that the file sets: the other one may be the default.
[[noreturn]] void refuse(const ConfigSection& section, const FieldSize& size, const Limit& limit) {
  const double small = size.*limit.smallSize, large = size.*limit.largeSize;
  const bool twice = limit.factor == 2;
  if (section.has(limit.small))
    section.fail(limit.small, std::string("must be at most ") + (twice ? "half of " : "") + limit.large +
                                  ", " + shortestText(large / limit.factor) + ", not " + shortestText(small));
  section.fail(limit.large, std::string("must be at least ") + (twice ? "twice " : "") + limit.small + ", " +
                                shortestText(limit.factor * small) + ", not " + shortestText(large));
}

}  // namespace

FieldSize readFieldSize(const ConfigSection& section) {
  FieldSize size;
  readParameters(section, FieldSize::parameterList(), &size);
  for (const Limit& limit : limits)
    if (limit.factor * (size.*limit.smallSize) > size.*limit.largeSize) refuse(section, size, limit);
  return size;
}

FieldSize readFieldFile(const std::string& path) {
  const ConfigFile file(path);
  const FieldSize size = readFieldSize(file.root());
  file.checkUnknown();
  return size;
}

}  // namespace plumbline
