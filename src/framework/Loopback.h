#pragma once
#include <string_view>

namespace plumbline {

/// True for the addresses of the loopback interface as numbers, 127.x.y.z and ::1, and for localhost; false
/// for every other name, whatever it begins with.
bool isLoopbackAddress(std::string_view address);

/// Whether two secrets are the same; how long that takes does not depend on where they differ.
bool sameSecret(std::string_view a, std::string_view b);

}  // namespace plumbline
