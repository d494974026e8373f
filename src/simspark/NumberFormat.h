#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace plumbline::simspark {

/// Appends value with exactly `decimals` digits (0..9) after the point, as printf("%.*f"): the number format
/// of the server's messages to agents, which has two. -0.001 gives "-0.00".
void appendFixed(std::string& out, double value, int decimals = 2);

/// Appends value with up to six significant digits, as printf("%g"): the number format of the monitor.
void appendGeneral(std::string& out, float value);

void appendInteger(std::string& out, int value);

/// The whole text as a finite number, or nothing.
std::optional<double> parseNumber(std::string_view text);
std::optional<int> parseInteger(std::string_view text);

}  // namespace plumbline::simspark
