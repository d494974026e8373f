#pragma once
#include <exception>
#include <functional>
#include <string>

namespace plumbline {

/// What the exception says that a call throws.
inline std::string thrownBy(const std::function<void()>& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "nothing thrown";
}

}  // namespace plumbline
