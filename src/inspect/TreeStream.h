#pragma once
#include <string>
#include <vector>

#include "framework/InStream.h"
#include "framework/OutStream.h"
#include "inspect/Tree.h"

namespace plumbline::inspect {

/// Makes a tree of what is written to it.
class TreeOutStream final : public OutStream {
public:
  explicit TreeOutStream(Tree& tree) : root_(tree) { root_ = {}; }

  void writeSigned(std::int64_t value, unsigned bytes) override;
  void writeUnsigned(std::uint64_t value, unsigned bytes) override;
  void writeBool(bool value) override;
  void writeChar(char value) override;
  void writeFloat(float value) override;
  void writeDouble(double value) override;
  void writeString(std::string_view value) override;
  void writeRaw(const void* data, std::size_t size) override;
  void beginObject() override;
  void endObject() override { open_.pop_back(); }
  void label(std::string_view name) override { label_ = name; }
  void beginList(std::size_t, bool) override { beginObject(); }
  void endList() override { endObject(); }

private:
  Tree& next();
  template <typename F>
  void leaf(F&& write);

  Tree& root_;
  std::vector<Tree*> open_;
  std::string label_;
};

/// Reads from a tree. Labels are ignored, the order counts. problem() names the part: "relative.x: expected a
/// number, found "far"". A number that is not finite is an error unless it was there before (`anyNumber`).
class TreeInStream final : public InStream {
public:
  explicit TreeInStream(const Tree& tree, bool anyNumber = false);

  void readSigned(std::int64_t& value, unsigned bytes) override;
  void readUnsigned(std::uint64_t& value, unsigned bytes) override;
  void readBool(bool& value) override;
  void readChar(char& value) override;
  void readFloat(float& value) override;
  void readDouble(double& value) override;
  void readString(std::string& value) override;
  void readRaw(void* data, std::size_t size) override;
  void beginObject() override;
  void endObject() override;
  void label(std::string_view name) override { label_ = name; }
  void beginList() override { beginObject(); }
  bool nextElement() override;
  void endList() override { endObject(); }

  /// "", or what was wrong and where.
  std::string problem() const;
  bool located() const { return !where_.empty(); }

protected:
  std::size_t position() const override { return 0; }

private:
  struct Open {
    const Tree* tree;
    std::size_t next;
    std::string label;
  };
  const Tree* next();
  void stop(const std::string& message);
  template <typename T>
  void number(T& value, void (InStream::*read)(T&));

  Tree root_;
  bool anyNumber_;
  std::vector<Open> open_;
  std::string label_, where_;
};

}  // namespace plumbline::inspect
