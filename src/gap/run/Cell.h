#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::gap {

/// Without blanks and one pair of quotes around it.
std::string_view trimmedCell(std::string_view text);

/// Reads a finite number that is the whole text, as 1e-3 or +0.5.
bool numberOf(std::string_view text, double& x);

/// The cells of a line. A separator within quotes is part of the cell; with `lists` also one within the
/// brackets that a cell begins with. False, with `lists`: quotes are open at the end of the line.
bool splitCells(std::string_view line, char separator, bool lists, std::vector<std::string_view>& cells);

/// Reads a list of numbers as Python's, pandas' and ROS' tools write it: "[0.1, 0.2]", "(0.1, 0.2)",
/// "array('d', [0.1, 0.2])", "[0.1 0.2]", "0.1 0.2", "0.1;0.2". `missing` are words for a lost number, NaN in
/// the result. False for a text of another form (also a list in a list) and for more than `longest` numbers.
bool listOf(std::string_view text, const std::vector<std::string>& missing, std::size_t longest,
            std::vector<double>& list);

}  // namespace plumbline::gap
