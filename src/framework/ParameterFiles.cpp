#include "framework/ParameterFiles.h"

namespace plumbline {

std::map<std::string, ParameterFile>& ParameterFiles::all() {
  static std::map<std::string, ParameterFile> files;
  return files;
}

}  // namespace plumbline
