#pragma once
#include <tinyxml2.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "framework/NearestName.h"
#include "robot/MechanismParts.h"

namespace plumbline {

/// Where an element stood that was put in from another file: the user data of its node.
struct XmlPlace {
  std::string file;
  int line = 0;
};

/// Attributes of XML elements as numbers and names; every mistake is a MechanismError with file and line.
class XmlElements {
public:
  explicit XmlElements(const std::string& file) : file(file) {}

protected:
  using XMLElement = tinyxml2::XMLElement;

  [[noreturn]] void fail(const XMLElement& at, const std::string& what) const {
    failMechanism(placeOf(at), what);
  }

  /// FILE:LINE.
  std::string placeOf(const XMLElement& e) const {
    const auto* const from = static_cast<const XmlPlace*>(e.GetUserData());
    return from ? from->file + ":" + std::to_string(from->line) : file + ":" + std::to_string(e.GetLineNum());
  }

  std::string attribute(const XMLElement& e, const char* name) const {
    const char* text = e.Attribute(name);
    if (!text) fail(e, std::string("<") + e.Name() + "> lacks " + name + "=\"...\"");
    return text;
  }

  /// Refuses attributes that nobody reads, where one of those read may be left out: a misspelt one would be
  /// silently missing.
  void only(const XMLElement* e, const std::vector<std::string>& known) const {
    if (!e) return;
    for (const tinyxml2::XMLAttribute* a = e->FirstAttribute(); a; a = a->Next())
      if (std::find(known.begin(), known.end(), a->Name()) == known.end())
        fail(*e, std::string("<") + e->Name() + "> " + std::string(a->Name()).substr(0, 60) +
                     ": unknown attribute" + suggestion(a->Name(), known));
  }

  /// Takes one number off the front of the text; false at its end.
  bool take(const XMLElement& e, const char* name, std::string_view& text, double& x) const {
    while (!text.empty() && static_cast<unsigned char>(text.front()) <= ' ') text.remove_prefix(1);
    if (text.empty()) return false;
    if (text.front() == '+') text.remove_prefix(1);
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), x);
    const bool whole = end == text.data() + text.size() || static_cast<unsigned char>(*end) <= ' ';
    if (error != std::errc() || !whole || !(std::abs(x) < 1e12))
      fail(e, std::string("<") + e.Name() + "> " + name + " is \"" + std::string(text.substr(0, 40)) +
                  "\", no number");
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    return true;
  }

  double number(const XMLElement& e, const char* name) const {
    const std::string text = attribute(e, name);
    std::string_view rest = text;
    double x = 0, more = 0;
    if (!take(e, name, rest, x) || take(e, name, rest, more))
      fail(e,
           std::string("<") + e.Name() + "> " + name + " is \"" + text.substr(0, 40) + "\"; give one number");
    return x;
  }

  double number(const XMLElement& e, const char* name, double fallback) const {
    return e.Attribute(name) ? number(e, name) : fallback;
  }

  /// As many numbers as there are, most of them at most.
  std::vector<double> numbers(const XMLElement& e, const char* name, std::size_t most = 16) const {
    std::vector<double> list;
    const char* text = e.Attribute(name);
    std::string_view rest = text ? text : "";
    for (double x = 0; take(e, name, rest, x);) {
      list.push_back(x);
      if (list.size() > most)
        fail(e, std::string("<") + e.Name() + "> " + name + " holds more than " + std::to_string(most) +
                    " numbers");
    }
    return list;
  }

  Vec3 vector(const XMLElement* e, const char* name, const Vec3& fallback) const {
    if (!e || !e->Attribute(name)) return fallback;
    const std::string text = attribute(*e, name);
    std::string_view rest = text;
    Vec3 v;
    double more = 0;
    bool whole = true;
    for (int i = 0; i < 3; ++i) whole = whole && take(*e, name, rest, v[i]);
    if (!whole || take(*e, name, rest, more))
      fail(*e, std::string("<") + e->Name() + "> " + name + " is \"" + text.substr(0, 40) +
                   "\"; give three numbers");
    return v;
  }

  const std::string& file;
};

}  // namespace plumbline
