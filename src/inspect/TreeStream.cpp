#include "inspect/TreeStream.h"

#include <cmath>

#include "framework/TextStream.h"

namespace plumbline::inspect {
namespace {

/// A stream's error without its position.
std::string bare(const std::string& error) {
  if (!error.starts_with("byte ")) return error;
  const auto colon = error.find(": ");
  return colon == std::string::npos ? error : bare(error.substr(colon + 2));
}

}  // namespace

Tree& TreeOutStream::next() {
  Tree& tree = open_.empty() ? root_ : open_.back()->parts.emplace_back();
  tree.label = std::move(label_);
  label_.clear();
  return tree;
}

template <typename F>
void TreeOutStream::leaf(F&& write) {
  Tree& tree = next();
  TextOutStream out(tree.text);
  write(out);
  if (!tree.text.empty()) tree.text.pop_back();  // the space behind it
}

void TreeOutStream::writeSigned(std::int64_t value, unsigned bytes) {
  leaf([&](OutStream& out) { out.writeSigned(value, bytes); });
}
void TreeOutStream::writeUnsigned(std::uint64_t value, unsigned bytes) {
  leaf([&](OutStream& out) { out.writeUnsigned(value, bytes); });
}
void TreeOutStream::writeBool(bool value) {
  leaf([&](OutStream& out) { out.writeBool(value); });
}
void TreeOutStream::writeChar(char value) {
  leaf([&](OutStream& out) { out.writeChar(value); });
}
void TreeOutStream::writeFloat(float value) {
  leaf([&](OutStream& out) { out.writeFloat(value); });
}
void TreeOutStream::writeDouble(double value) {
  leaf([&](OutStream& out) { out.writeDouble(value); });
}
void TreeOutStream::writeString(std::string_view value) {
  leaf([&](OutStream& out) { out.writeString(value); });
}
void TreeOutStream::writeRaw(const void* data, std::size_t size) {
  leaf([&](OutStream& out) { out.writeRaw(data, size); });
}

void TreeOutStream::beginObject() {
  Tree& tree = next();
  tree.group = true;
  open_.push_back(&tree);
}

TreeInStream::TreeInStream(const Tree& tree, bool anyNumber) : anyNumber_(anyNumber) {
  root_.group = true;
  root_.parts.push_back(tree);
  open_.push_back({&root_, 0, {}});
}

void TreeInStream::stop(const std::string& message) {
  if (!ok()) return;
  for (std::size_t i = 1; i < open_.size(); ++i) {
    if (open_[i].label.empty()) continue;
    if (!where_.empty()) where_ += '.';
    where_ += open_[i].label;
  }
  if (!label_.empty()) where_ += (where_.empty() ? "" : ".") + label_;
  fail(message);
}

std::string TreeInStream::problem() const {
  if (ok()) return {};
  return where_.empty() ? bare(error()) : where_ + ": " + bare(error());
}

const Tree* TreeInStream::next() {
  if (!ok()) return nullptr;
  Open& top = open_.back();
  if (top.next < top.tree->parts.size()) return &top.tree->parts[top.next++];
  stop("a value is missing");
  return nullptr;
}

template <typename T>
void TreeInStream::number(T& value, void (InStream::*read)(T&)) {
  const Tree* tree = next();
  if (!tree) return;
  if (tree->group) return stop("expected a single value, found a group");
  TextInStream in(tree->text);
  T wanted = value;
  (in.*read)(wanted);
  if (!in.ok()) return stop(bare(in.error()));
  if (!in.atEnd()) return stop("text left over");
  if constexpr (std::is_floating_point_v<T>) {
    if (!anyNumber_ && !std::isfinite(wanted)) return stop("must be finite, not " + tree->text);
  }
  value = std::move(wanted);
  label_.clear();
}

void TreeInStream::readSigned(std::int64_t& value, unsigned bytes) {
  const Tree* tree = next();
  if (!tree) return;
  TextInStream in(tree->text);
  in.readSigned(value, bytes);
  if (tree->group || !in.ok())
    return stop(tree->group ? "expected an integer, found a group" : bare(in.error()));
  label_.clear();
}

void TreeInStream::readUnsigned(std::uint64_t& value, unsigned bytes) {
  const Tree* tree = next();
  if (!tree) return;
  TextInStream in(tree->text);
  in.readUnsigned(value, bytes);
  if (tree->group || !in.ok())
    return stop(tree->group ? "expected an integer, found a group" : bare(in.error()));
  label_.clear();
}

void TreeInStream::readBool(bool& value) { number(value, &InStream::readBool); }
void TreeInStream::readChar(char& value) { number(value, &InStream::readChar); }
void TreeInStream::readFloat(float& value) { number(value, &InStream::readFloat); }
void TreeInStream::readDouble(double& value) { number(value, &InStream::readDouble); }
void TreeInStream::readString(std::string& value) {
  const Tree* at = ok() && !open_.empty() && open_.back().next < open_.back().tree->parts.size()
                       ? &open_.back().tree->parts[open_.back().next]
                       : nullptr;
  // A word needs no quotes.
  if (!at || at->group || at->text.empty() || at->text[0] == '"') return number(value, &InStream::readString);
  value = at->text;
  open_.back().next++;
  label_.clear();
}

void TreeInStream::readRaw(void* data, std::size_t size) {
  const Tree* tree = next();
  if (!tree) return;
  if (tree->group) return stop("expected a block of memory, found a group");
  TextInStream in(tree->text);
  in.readRaw(data, size);
  if (!in.ok()) return stop(bare(in.error()));
  label_.clear();
}

void TreeInStream::beginObject() {
  const Tree* tree = next();
  if (!tree) return;
  if (!tree->group) return stop("expected values in {}, found \"" + tree->text.substr(0, 40) + '"');
  open_.push_back({tree, 0, std::move(label_)});
  label_.clear();
}

void TreeInStream::endObject() {
  if (!ok()) return;
  const Open& top = open_.back();
  if (const std::size_t more = top.tree->parts.size() - top.next; more > 0)
    return stop("holds " + std::to_string(more) + (more == 1 ? " value" : " values") + " too many");
  open_.pop_back();
}

bool TreeInStream::nextElement() { return ok() && open_.back().next < open_.back().tree->parts.size(); }

}  // namespace plumbline::inspect
