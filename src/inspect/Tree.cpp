#include "inspect/Tree.h"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "framework/NearestName.h"

namespace plumbline::inspect {
namespace {

class Parser {
public:
  explicit Parser(std::string_view text) : text_(text) {}

  std::string parse(Tree& tree) {
    value(tree, 0);
    skip();
    if (error_.empty() && at_ < text_.size()) error_ = "text left over: \"" + rest() + '"';
    return error_;
  }

private:
  void skip() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t')) ++at_;
  }
  bool ended() const { return at_ >= text_.size(); }
  std::string rest() const { return std::string(text_.substr(at_, 20)); }

  void value(Tree& tree, unsigned depth) {
    skip();
    if (!ended() && text_[at_] == '[') {
      const auto end = text_.find(']', at_);
      if (end == std::string_view::npos) return fail("a label has no ]");
      tree.label = text_.substr(at_ + 1, end - at_ - 1);
      at_ = end + 1;
      skip();
    }
    if (ended()) return fail("a value is missing");
    if (text_[at_] == '{') return group(tree, depth);
    if (text_[at_] == '}') return fail("a } without {");
    const std::size_t begin = at_;
    text_[at_] == '"' || text_[at_] == '\'' ? quoted() : word();
    tree.text = text_.substr(begin, at_ - begin);
  }

  void group(Tree& tree, unsigned depth) {
    if (depth == maxTreeDepth) return fail("nested too deeply");
    tree.group = true;
    for (++at_;;) {
      skip();
      if (ended()) return fail("a } is missing");
      if (text_[at_] == '}') break;
      value(tree.parts.emplace_back(), depth + 1);
      if (!error_.empty()) return;
    }
    ++at_;
  }

  void quoted() {
    const char quote = text_[at_];
    for (++at_; !ended() && text_[at_] != quote; ++at_) {
      if (text_[at_] == '\\') ++at_;
    }
    if (ended()) {
      at_ = text_.size();
      return fail("a closing quote is missing");
    }
    ++at_;
  }

  void word() {
    while (!ended() && std::string_view(" \t{}[]\"'").find(text_[at_]) == std::string_view::npos) ++at_;
    if (!ended() && (text_[at_] == ']' || text_[at_] == '"' || text_[at_] == '\''))
      fail("unexpected \"" + rest() + '"');
  }

  void fail(const std::string& error) {
    if (error_.empty()) error_ = error;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::string error_;
};

void print(const Tree& tree, std::string& text) {
  if (!tree.label.empty()) text += '[' + tree.label + "] ";
  if (!tree.group) {
    text += tree.text;
    return;
  }
  text += '{';
  for (std::size_t i = 0; i < tree.parts.size(); ++i) {
    if (i > 0) text += ' ';
    print(tree.parts[i], text);
  }
  text += '}';
}

/// The characters between the quotes, as the text form escapes them.
std::string unquoted(std::string_view text) {
  std::string result;
  for (std::size_t i = 1; i + 1 < text.size(); ++i) {
    char c = text[i];
    if (c == '\\' && i + 2 < text.size()) {
      c = text[++i];
      if (c == 'n') c = '\n';
      if (c == 'x' && i + 3 < text.size()) {
        unsigned code = 0;
        std::from_chars(text.data() + i + 1, text.data() + i + 3, code, 16);
        c = static_cast<char>(code);
        i += 2;
      }
    }
    result += c;
  }
  return result;
}

nlohmann::json leafJson(const std::string& text) {
  if (text == "true" || text == "false") return text == "true";
  if (!text.empty() && (text[0] == '"' || text[0] == '\'')) return unquoted(text);
  const char* end = text.data() + text.size();
  std::int64_t integer = 0;
  if (const auto read = std::from_chars(text.data(), end, integer); read.ec == std::errc{} && read.ptr == end)
    return integer;
  double number = 0;
  const auto read = std::from_chars(text.data(), end, number);
  if (read.ec != std::errc{} || read.ptr != end) return text;
  return std::isfinite(number) ? nlohmann::json(number) : nlohmann::json(nullptr);
}

Tree* element(Tree& tree, std::string_view digits, std::string& error) {
  std::size_t index = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), index);
  if (read.ec != std::errc{} || read.ptr != digits.data() + digits.size())
    error = "an element's number must be in [], not \"" + std::string(digits.substr(0, 20)) + '"';
  else if (!tree.group)
    error = "is a single value and has no element [" + std::to_string(index) + ']';
  else if (index >= tree.parts.size())
    error = "has no element [" + std::to_string(index) + "]; it has " + std::to_string(tree.parts.size());
  else
    return &tree.parts[index];
  return nullptr;
}

Tree* member(Tree& tree, std::string_view label, std::string& error) {
  std::vector<std::string> labels;
  for (Tree& part : tree.parts) {
    if (part.label == label && !label.empty()) return &part;
    if (!part.label.empty()) labels.push_back(part.label);
  }
  const std::string name(label.substr(0, 60));
  if (!tree.group) {
    error = "is a single value and has no part " + name;
  } else if (labels.empty()) {
    error = "is a list of " + std::to_string(tree.parts.size()) + "; its elements are [0], [1], ...";
  } else {
    error = "has no part " + name + "; it has ";
    for (std::size_t i = 0; i < labels.size(); ++i) error += (i > 0 ? ", " : "") + labels[i];
  }
  return nullptr;
}

}  // namespace

std::string parseTree(std::string_view text, Tree& tree) {
  tree = {};
  return Parser(text).parse(tree);
}

std::string treeText(const Tree& tree) {
  std::string text;
  Tree plain{"", tree.text, tree.group, {}};
  if (!tree.group) return tree.text;
  plain.parts = tree.parts;
  print(plain, text);
  return text;
}

nlohmann::json treeJson(const Tree& tree) {
  if (!tree.group) return leafJson(tree.text);
  if (tree.parts.empty() || tree.parts.front().label.empty()) {
    auto list = nlohmann::json::array();
    for (const Tree& part : tree.parts) list.push_back(treeJson(part));
    return list;
  }
  auto object = nlohmann::json::object();
  for (const Tree& part : tree.parts) object[part.label] = treeJson(part);
  return object;
}

Tree* findPart(Tree& tree, std::string_view path, std::string& error) {
  Tree* at = &tree;
  std::size_t begin = 0;
  while (begin < path.size() && at) {
    const std::string before(path.substr(0, begin));
    const char kind = path[begin];
    std::size_t end = path.find_first_of(".[", begin + 1);
    if (end == std::string_view::npos) end = path.size();
    const std::string_view step = path.substr(begin + 1, end - begin - 1);
    if (kind == '.') {
      at = member(*at, step, error);
    } else if (kind == '[' && !step.empty() && step.back() == ']') {
      at = element(*at, step.substr(0, step.size() - 1), error);
    } else {
      error = "parts are written .name or [number], not \"" + std::string(path.substr(begin, 20)) + '"';
      at = nullptr;
    }
    if (!at) error = before + ' ' + error;
    begin = end;
  }
  return at;
}

std::vector<std::string> partPaths(const Tree& tree, std::size_t most) {
  std::vector<std::string> paths;
  for (std::size_t i = 0; i < tree.parts.size() && paths.size() < most; ++i) {
    const std::string& label = tree.parts[i].label;
    paths.push_back(label.empty() ? '[' + std::to_string(i) + ']' : '.' + label);
  }
  return paths;
}

}  // namespace plumbline::inspect
