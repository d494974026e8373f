#pragma once
#include <tinyxml2.h>

#include <deque>
#include <filesystem>
#include <set>
#include <string>

#include "robot/XmlElements.h"

namespace plumbline {

/// A model of MuJoCo as one document: each <include> is replaced by the content of the file that it names.
/// Elements from there know their file and line (XmlPlace). Throws MechanismError.
class MjcfDocument : private XmlElements {
public:
  /// text: of the main file, whose folder and the folders in it hold all that is included.
  MjcfDocument(const std::string& text, const std::string& mainFile);

  /// <mujoco>
  const XMLElement& root() const { return *root_; }

private:
  void parse(const std::string& text, const std::string& of, tinyxml2::XMLDocument& document) const;
  void expand(XMLElement& parent, const std::string& of, int depth);
  void replace(XMLElement& include, const std::string& of, int depth);
  std::filesystem::path find(const XMLElement& include, const std::string& of) const;
  XMLElement* copyInto(tinyxml2::XMLDocument& document, const XMLElement& e, const std::string& of);
  std::string placeIn(const std::string& of, const XMLElement& e) const;

  tinyxml2::XMLDocument document_;
  std::deque<XmlPlace> places_;
  std::set<std::filesystem::path> read_;  ///< the files so far
  std::size_t size_ = 0;                  ///< of their text
  XMLElement* root_ = nullptr;
};

}  // namespace plumbline
