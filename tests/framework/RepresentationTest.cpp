#include "framework/Representation.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>
#include <string>
#include <vector>

#include "framework/BinaryStream.h"
#include "framework/RepresentationLoader.h"
#include "framework/TextStream.h"

namespace plumbline {

REPRESENTATION(PlainData)
class PlainData : public PlainDataBase {
public:
  int count = 258;
  double values[2] = {1, 2};
};

/// Without bytes between its members.
REPRESENTATION(PackedData)
class PackedData : public PackedDataBase {
public:
  double values[2] = {1, 2};
};

REPRESENTATION(OwningData)
class OwningData : public OwningDataBase {
public:
  std::vector<std::string> words;
  void stream(InStream* in, OutStream* out) override { STREAM(words); }
};

REPRESENTATION(EmptyData)
class EmptyData : public EmptyDataBase {};

REPRESENTATION(ForgetfulData)
class ForgetfulData : public ForgetfulDataBase {
public:
  std::string word;
};

REPRESENTATION(MatrixData)
class MatrixData : public MatrixDataBase {
public:
  Eigen::Vector3d vector = {1, 2, 3};
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  std::optional<double> maybe = 4;
};

namespace {

// What is false here does not compile in a module.
static_assert(knowsHowToStream<PlainData> && knowsHowToStream<OwningData> && knowsHowToStream<EmptyData>);
static_assert(knowsHowToStream<MatrixData>);
static_assert(!knowsHowToStream<ForgetfulData>);

TEST(RepresentationTest, theLoaderKnowsTheBytesOfWhatOwnsNoMemory) {
  PackedData one, other;
  const RepresentationLoader& plain = representationLoader<PackedData>();
  const auto same = [&] { return std::ranges::equal(*plain.plainBytes(one), *plain.plainBytes(other)); };
  EXPECT_TRUE(same());
  other.values[1] = 2.5;
  EXPECT_FALSE(same());
  plain.copy(one, other);
  EXPECT_TRUE(same());
  const OwningData words;
  EXPECT_FALSE(representationLoader<OwningData>().plainBytes(words).has_value());
}

TEST(RepresentationTest, eigenAndOptionalMembersGoAsABlock) {
  MatrixData data, back;
  data.pose.translation() = Eigen::Vector3d(5, 6, 7);
  back.vector.setZero();
  back.maybe = std::nullopt;
  EXPECT_EQ(fromBinary(toBinary(data), back), "");
  EXPECT_EQ(back.vector, data.vector);
  EXPECT_EQ(back.pose.translation(), data.pose.translation());
  EXPECT_EQ(back.maybe, 4);
}

TEST(RepresentationTest, withoutAStreamMethodItIsABlockOfMemory) {
  PlainData data;
  const std::string bytes = toBinary(data);
  EXPECT_EQ(bytes.size(), sizeof(PlainData) - sizeof(void*));
  PlainData back;
  back.count = 0;
  back.values[1] = 0;
  EXPECT_EQ(fromBinary(bytes, back), "");
  EXPECT_EQ(back.count, 258);
  EXPECT_EQ(back.values[1], 2);
  EXPECT_EQ(fromBinary(bytes.substr(1), back), "byte 0: 24 bytes needed, 23 left");
}

TEST(RepresentationTest, theBlockIsHexadecimalInText) {
  PlainData data;
  const std::string text = toText(data);
  EXPECT_EQ(text.substr(0, 10), "{#02010000");
  PlainData back;
  back.count = 0;
  EXPECT_EQ(fromText(text, back), "");
  EXPECT_EQ(back.count, 258);
  EXPECT_EQ(fromText("{#0201}", back), "byte 1: expected # and 48 hexadecimal digits, found \"#0201\"");
}

TEST(RepresentationTest, emptyOnesAreFine) {
  EmptyData data;
  EXPECT_EQ(toBinary(data), "");
  EXPECT_EQ(fromBinary("", data), "");
}

TEST(RepresentationTest, theLoaderMakesAndCopiesThem) {
  const RepresentationLoader& loader = representationLoader<OwningData>();
  EXPECT_EQ(loader.name(), "OwningData");
  EXPECT_EQ(&loader, &representationLoader<OwningData>());
  const auto from = loader.create(), to = loader.create();
  static_cast<OwningData&>(from->get()).words = {"a", "b"};
  loader.copy(from->get(), to->get());
  EXPECT_EQ(static_cast<OwningData&>(to->get()).words, (std::vector<std::string>{"a", "b"}));
}

}  // namespace
}  // namespace plumbline
