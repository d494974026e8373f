#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace plumbline::fuzz {

/// Inputs in one file: of each its length [bytes, decimal], a line end, its bytes, a line end. Throws
/// std::runtime_error with the file's name when it is not so.
std::vector<std::string> packedInputs(const std::string& path);

/// What earlier runs of `make fuzz` left for every later test run, in a folder such as tests/data/fuzz. The
/// inputs of TARGET.inputs together reach all known code of the reader. Each of the files found/TARGET-* once
/// broke it.
std::vector<std::string> keptInputs(const std::string& folder, std::string_view target);

}  // namespace plumbline::fuzz
