#pragma once
#include <string>

#include "framework/Registry.h"

namespace plumbline {

/// A page in Markdown of every parameter of every module: type, default, unit, range, comment.
std::string parameterPage(const Registry& registry = Registry::instance());

}  // namespace plumbline
