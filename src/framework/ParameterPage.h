#pragma once
#include <string>

#include "framework/ParameterFiles.h"
#include "framework/Registry.h"

namespace plumbline {

/// How a table names the parameters of a group.
enum class GroupNames { path, member };  ///< "walk.maxForward" or "maxForward"

/// A table in Markdown of the parameters of `owner`: type, default, unit, range, comment.
std::string parameterTable(const ParameterList& parameters, void* owner, GroupNames names = GroupNames::path);

/// A page in Markdown of every parameter of every module and of the files that are no module's: type,
/// default, unit, range, comment.
std::string parameterPage(const Registry& registry = Registry::instance(),
                          const std::map<std::string, ParameterFile>& files = ParameterFiles::all());

}  // namespace plumbline
