#pragma once
#include <cstddef>
#include <stdexcept>
#include <string>

namespace plumbline {

/// What is wrong with a file: "cannot be read: REASON" or "is larger than N MB". The caller puts the path
/// before it.
class FileProblem : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// All bytes of a file of at most maxBytes, which are whole megabytes. Throws FileProblem.
std::string readFile(const std::string& path, std::size_t maxBytes);

}  // namespace plumbline
