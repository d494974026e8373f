#pragma once
#include <cstddef>
#include <stdexcept>
#include <string>

namespace plumbline {

/// Why a file cannot be had: "cannot be read: REASON" or "is larger than N MB". Its path is for the caller to
/// say.
class FileProblem : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// All bytes of a file of at most maxBytes, which are whole megabytes. Throws FileProblem.
std::string readFile(const std::string& path, std::size_t maxBytes);

}  // namespace plumbline
