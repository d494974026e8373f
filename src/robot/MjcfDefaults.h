#pragma once
#include <map>
#include <optional>
#include <string>

#include "robot/XmlElements.h"

namespace plumbline {

/// The default classes of a model of MuJoCo, and which limits hold.
class MjcfDefaults : protected XmlElements {
public:
  using XmlElements::XmlElements;

  /// All <default> of the model.
  void readDefaults(const XMLElement& root);

  /// Fills missing attributes of an element from its class.
  void complete(const XMLElement& e, const std::string& classAround) const;

  /// A range of two numbers if it is in force: its flag is true, or it is auto and the range is not empty.
  std::optional<Vec2> rangeOf(const XMLElement& e, const char* range, const char* flag) const;

  bool rangesHoldByThemselves = true;  ///< <compiler autolimits>

private:
  using Attributes = std::map<std::string, std::string>;
  using Class = std::map<std::string, Attributes>;

  void readClass(const XMLElement& e, const std::string& around, int depth);

  std::map<std::string, Class> classes_;
};

}  // namespace plumbline
