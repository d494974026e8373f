#include "situation/Rounded.h"

#include <fmt/format.h>

#include <cmath>

namespace plumbline {

std::string rounded(double number) { return fmt::format("{:g}", std::round(100 * number) / 100 + 0.0); }

}  // namespace plumbline
