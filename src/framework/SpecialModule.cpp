#include "framework/SpecialModule.h"

namespace plumbline {

std::map<std::string, SpecialModules::Maker>& SpecialModules::makers() {
  static std::map<std::string, Maker> map;
  return map;
}

}  // namespace plumbline
