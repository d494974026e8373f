#pragma once
#include <string>

#include "framework/ParameterFiles.h"
#include "framework/Registry.h"

namespace plumbline {

/// A page in Markdown of every parameter of every module and of the files that are no module's: type,
/// default, unit, range, comment.
std::string parameterPage(const Registry& registry = Registry::instance(),
                          const std::map<std::string, ParameterFile>& files = ParameterFiles::all());

}  // namespace plumbline
