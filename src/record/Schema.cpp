#include "record/Schema.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <stdexcept>

#include "framework/StreamTypes.h"

namespace plumbline::record {
namespace {

constexpr std::size_t maxParts = 100'000, maxRaw = std::size_t{1} << 26;
constexpr unsigned maxDepth = 48;

constexpr std::array<std::string_view, 14> kindWords = {"b",  "c",  "i1", "i2", "i4", "i8", "u1",
                                                        "u2", "u4", "u8", "f4", "f8", "s",  "r"};

std::string cleanLabel(std::string_view text) {
  std::string label(text);
  for (char& c : label)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '_') c = '_';
  return label;
}

class SchemaStream final : public InStream {
public:
  explicit SchemaStream(Schema& root) : root_(root) {}

  void readSigned(std::int64_t&, unsigned bytes) override { leaf(whole(Schema::Kind::int8, bytes)); }
  void readUnsigned(std::uint64_t&, unsigned bytes) override { leaf(whole(Schema::Kind::uint8, bytes)); }
  void readBool(bool&) override { leaf(Schema::Kind::boolean); }
  void readChar(char&) override { leaf(Schema::Kind::character); }
  void readFloat(float&) override { leaf(Schema::Kind::float32); }
  void readDouble(double&) override { leaf(Schema::Kind::float64); }
  void readString(std::string&) override { leaf(Schema::Kind::text); }
  void readRaw(void*, std::size_t size) override {
    if (Schema* part = next(Schema::Kind::raw)) part->size = size;
  }
  void beginObject() override { open(Schema::Kind::object); }
  void endObject() override {
    if (ok()) open_.pop_back();
  }
  void label(std::string_view name) override { label_ = cleanLabel(name); }
  void beginList() override { open(Schema::Kind::list); }
  /// One element: it describes the whole list.
  bool nextElement() override { return ok() && open_.back()->parts.empty(); }
  void endList() override { endObject(); }

protected:
  std::size_t position() const override { return count_; }

private:
  static Schema::Kind whole(Schema::Kind smallest, unsigned bytes) {
    const int step = bytes == 1 ? 0 : bytes == 2 ? 1 : bytes == 4 ? 2 : 3;
    return static_cast<Schema::Kind>(static_cast<int>(smallest) + step);
  }
  Schema* next(Schema::Kind kind) {
    if (!ok()) return nullptr;
    if (++count_ > maxParts || open_.size() > maxDepth) {
      fail("the type has no end");
      return nullptr;
    }
    Schema& part = open_.empty() ? root_ : open_.back()->parts.emplace_back();
    part.kind = kind;
    part.label = std::move(label_);
    label_.clear();
    return &part;
  }
  void leaf(Schema::Kind kind) { next(kind); }
  void open(Schema::Kind kind) {
    if (Schema* part = next(kind)) open_.push_back(part);
  }

  Schema& root_;
  std::vector<Schema*> open_;
  std::string label_;
  std::size_t count_ = 0;
};

void write(const Schema& schema, std::string& text) {
  if (schema.kind < Schema::Kind::object) {
    text += kindWords[static_cast<std::size_t>(schema.kind)];
    if (schema.kind == Schema::Kind::raw) text += std::to_string(schema.size);
    return;
  }
  text += schema.kind == Schema::Kind::object ? '{' : '[';
  for (std::size_t i = 0; i < schema.parts.size();) {
    if (i > 0) text += ' ';
    std::size_t same = i + 1;
    while (same < schema.parts.size() && schema.parts[same] == schema.parts[i]) same++;
    const Schema& part = schema.parts[i];
    if (!part.label.empty()) text += part.label + ':';
    write(part, text);
    if (same - i > 1) text += '*' + std::to_string(same - i);
    i = same;
  }
  text += schema.kind == Schema::Kind::object ? '}' : ']';
}

/// Itself and all below it.
std::size_t countParts(const Schema& schema) {
  std::size_t count = 1;
  for (const Schema& part : schema.parts) count += countParts(part);
  return count;
}

class Reader {
public:
  explicit Reader(std::string_view text) : text_(text) {}

  Schema all() {
    Schema schema = part(0);
    if (at_ < text_.size()) fail();
    return schema;
  }

private:
  [[noreturn]] void fail() const {
    throw std::runtime_error("no form of a message at character " + std::to_string(at_ + 1));
  }
  bool is(char c) const { return at_ < text_.size() && text_[at_] == c; }
  std::size_t number(std::size_t limit) {
    std::size_t value = 0;
    const auto [end, error] = std::from_chars(text_.data() + at_, text_.data() + text_.size(), value);
    if (error != std::errc{} || value > limit) fail();
    at_ = static_cast<std::size_t>(end - text_.data());
    return value;
  }
  std::string_view word() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && (std::isalnum(static_cast<unsigned char>(text_[at_])) || text_[at_] == '_'))
      at_++;
    return text_.substr(begin, at_ - begin);
  }
  Schema part(unsigned depth) {
    if (depth > maxDepth || ++count_ > maxParts) fail();
    Schema schema;
    // The whole has no name: nothing would write it.
    if (const std::size_t begin = at_; depth > 0 && !is('{') && !is('[')) {
      const std::string_view first = word();
      if (is(':')) {
        schema.label = first;
        at_++;
      } else {
        at_ = begin;
      }
    }
    if (is('{') || is('[')) {
      schema.kind = is('{') ? Schema::Kind::object : Schema::Kind::list;
      const char close = is('{') ? '}' : ']';
      at_++;
      while (!is(close)) {
        if (!schema.parts.empty() && is(' ')) at_++;
        schema.parts.push_back(part(depth + 1));
        if (!is('*')) continue;
        at_++;
        const std::size_t copies = number(maxParts);
        const Schema one = schema.parts.back();
        count_ += copies * countParts(one);
        if (copies == 0 || count_ > maxParts) fail();
        schema.parts.resize(schema.parts.size() + copies - 1, one);
      }
      at_++;
      if (schema.kind == Schema::Kind::list && schema.parts.size() != 1) fail();
      return schema;
    }
    if (is('r')) {
      at_++;
      schema.kind = Schema::Kind::raw;
      schema.size = number(maxRaw);
      return schema;
    }
    const auto found = std::find(kindWords.begin(), kindWords.end(), word());
    if (found == kindWords.end()) fail();
    schema.kind = static_cast<Schema::Kind>(found - kindWords.begin());
    return schema;
  }

  std::string_view text_;
  std::size_t at_ = 0, count_ = 0;
};

}  // namespace

bool Schema::isArray() const {
  return kind == Schema::Kind::object && !parts.empty() && parts.front().label.empty() &&
         std::all_of(parts.begin(), parts.end(), [&](const Schema& p) { return p == parts.front(); });
}

Schema schemaOf(const RepresentationLoader& loader) {
  const auto value = loader.create();  // the stream leaves traces in it
  Schema root;
  SchemaStream stream(root);
  StreamType<Representation>::read(stream, value->get());
  if (!stream.ok()) throw std::runtime_error(stream.error());
  return root;
}

std::string schemaText(const Schema& schema) {
  std::string text;
  write(schema, text);
  return text;
}

Schema schemaFromText(std::string_view text) { return Reader(text).all(); }

}  // namespace plumbline::record
