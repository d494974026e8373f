#include "framework/YamlLimits.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <vector>

#include "framework/ConfigurationError.h"

namespace plumbline {
namespace {

class Counter final : public YAML::EventHandler {
public:
  Counter(const std::string& path, const YamlLimits& limits) : path_(path), limits_(limits) {}

  void OnDocumentStart(const YAML::Mark& mark) override {
    sizes_.clear();  // an alias is one of its own document
    see({1, 0}, mark);
  }
  void OnDocumentEnd() override {}
  void OnNull(const YAML::Mark& mark, YAML::anchor_t anchor) override { leaf(mark, anchor); }
  void OnScalar(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                const std::string&) override {
    leaf(mark, anchor);
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t anchor) override {
    const auto known = sizes_.find(anchor);
    if (known == sizes_.end()) fail(mark, "an alias refers to a value that contains it");
    see(known->second, mark);
    into(known->second);
  }
  void OnSequenceStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                       YAML::EmitterStyle::value) override {
    begin(mark, anchor);
  }
  void OnMapStart(const YAML::Mark& mark, const std::string&, YAML::anchor_t anchor,
                  YAML::EmitterStyle::value) override {
    begin(mark, anchor);
  }
  void OnSequenceEnd() override { end(); }
  void OnMapEnd() override { end(); }

private:
  struct Size {
    std::size_t values = 0;
    int height = 0;
  };
  struct Open {
    YAML::anchor_t anchor;
    Size inside;  ///< with itself, without its own level
  };

  void leaf(const YAML::Mark& mark, YAML::anchor_t anchor) {
    if (anchor) sizes_[anchor] = {1, 0};
    see({1, 0}, mark);
    into({1, 0});
  }
  void begin(const YAML::Mark& mark, YAML::anchor_t anchor) {
    see({1, 1}, mark);
    open_.push_back({anchor, {1, 0}});
  }
  void end() {
    const auto [anchor, inside] = open_.back();
    const Size size{inside.values, inside.height + 1};
    open_.pop_back();
    if (anchor) sizes_[anchor] = size;
    into(size);
  }
  void see(const Size& size, const YAML::Mark& mark) {
    values_ += size.values;
    if (values_ > limits_.values) fail(mark, "more than " + std::to_string(limits_.values) + " values");
    if (static_cast<int>(open_.size()) + size.height > limits_.depth)
      fail(mark, "nested deeper than " + std::to_string(limits_.depth) + " levels");
  }
  void into(const Size& size) {
    if (open_.empty()) return;
    open_.back().inside.values += size.values;
    open_.back().inside.height = std::max(open_.back().inside.height, size.height);
  }
  [[noreturn]] void fail(const YAML::Mark& mark, const std::string& what) const {
    throw ConfigurationError(path_ + ":" + std::to_string(std::max(0, mark.line) + 1) + ": " + what);
  }

  const std::string& path_;
  YamlLimits limits_;
  std::size_t values_ = 0;
  std::vector<Open> open_;
  std::map<YAML::anchor_t, Size> sizes_;  ///< of what is complete
};

}  // namespace

void checkYamlLimits(const std::string& text, const std::string& path, const YamlLimits& limits) {
  std::istringstream stream(text);
  YAML::Parser parser(stream);
  Counter counter(path, limits);
  while (parser.HandleNextDocument(counter)) {
  }
}

}  // namespace plumbline
