#pragma once
#include <string>

namespace plumbline {

/// A number with two decimals at most, without zeros at its end: "1.5", "-0.25", "3".
std::string rounded(double number);

/// Several of them: "1.5, -0.25".
template <typename Numbers>
std::string rounded(const Numbers& numbers) {
  std::string text;
  for (const double number : numbers) text += (text.empty() ? "" : ", ") + rounded(number);
  return text;
}

}  // namespace plumbline
