#include "dds/RepresentationContent.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

#include "framework/BinaryStream.h"
#include "framework/SharedBlock.h"

namespace plumbline {

REPRESENTATION(CarriedMap)
class CarriedMap : public CarriedMapBase {
public:
  std::string name;
  double scale = 1;
  SharedBlock<float> cells;
  std::string problem() const { return scale > 0 ? "" : "scale: must be above 0"; }
  void stream(InStream* in, OutStream* out) override {
    STREAM(name);
    if (in && name == "unknown") throw std::runtime_error("no map unknown");
    STREAM(scale);
    STREAM(cells);
  }
};

REPRESENTATION(CarriedOther)
class CarriedOther : public CarriedOtherBase {
public:
  float scale = 1;
  void stream(InStream* in, OutStream* out) override { STREAM(scale); }
};

namespace dds {
namespace {

CarriedMap& mapOf(RepresentationContent& content) { return static_cast<CarriedMap&>(content.value()); }

std::string bytesOf(const RepresentationContent& content) {
  std::string bytes(content.size(), 0);
  EXPECT_TRUE(content.write(bytes.data(), bytes.size()));
  return bytes;
}

struct RepresentationContentTest : testing::Test {
  RepresentationContent sent{representationLoader<CarriedMap>()}, read{representationLoader<CarriedMap>()};

  RepresentationContentTest() {
    mapOf(sent).name = "field";
    mapOf(sent).cells = SharedBlock<float>(3, 0.5F);
  }
  std::string problemOfSent() {
    read.read(bytesOf(sent));
    return read.problem();
  }
};

TEST_F(RepresentationContentTest, isTheShapeAndTheBinaryStream) {
  const std::string bytes = bytesOf(sent);
  EXPECT_EQ(bytes.substr(8), toBinary(mapOf(sent)));
  read.read(bytes);
  EXPECT_EQ(read.problem(), "");
  EXPECT_EQ(mapOf(read).name, "field");
  EXPECT_EQ(mapOf(read).cells, mapOf(sent).cells);
  std::string small(bytes.size() - 1, 0);
  EXPECT_FALSE(sent.write(small.data(), small.size()));
}

TEST_F(RepresentationContentTest, isHeldToWhatModulesAreHeldTo) {
  mapOf(sent).cells.edit()[2] = std::numeric_limits<float>::infinity();
  EXPECT_EQ(problemOfSent(), "cells: must be finite, not inf");
  mapOf(sent).cells.edit()[2] = 0;
  mapOf(sent).scale = 0;
  EXPECT_EQ(problemOfSent(), "scale: must be above 0");
  mapOf(sent).scale = 2;
  EXPECT_EQ(problemOfSent(), "");
  EXPECT_EQ(mapOf(read).scale, 2);
}

TEST_F(RepresentationContentTest, saysWhatCannotBeRead) {
  const std::string good = bytesOf(sent);
  read.read(good.substr(0, good.size() - 1));
  EXPECT_EQ(read.problem(), "byte 29: 4 bytes needed, 3 left");
  read.read(good + "x");
  EXPECT_EQ(read.problem(), "byte 33: bytes left over");
  read.read("");
  EXPECT_EQ(read.problem(), "its members are others than here: are both programs of one version?");
  RepresentationContent other(representationLoader<CarriedOther>());
  read.read(bytesOf(other));
  EXPECT_EQ(read.problem(), "its members are others than here: are both programs of one version?");
  read.read(good);
  EXPECT_EQ(read.problem(), "");
}

TEST_F(RepresentationContentTest, whatWasHalfReadDoesNotStay) {
  mapOf(sent).name = "unknown";
  EXPECT_EQ(problemOfSent(), "no map unknown");
  EXPECT_EQ(mapOf(read).name, "") << "made anew";
}

}  // namespace
}  // namespace dds
}  // namespace plumbline
