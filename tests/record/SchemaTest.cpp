#include "record/Schema.h"

#include <gtest/gtest.h>

#include "framework/StreamTypes.h"
#include "record/ExampleLog.h"
#include "record/RosMessage.h"
#include "support/Thrown.h"

namespace plumbline {

REPRESENTATION(PlainBlock)
class PlainBlock : public PlainBlockBase {
public:
  double a = 0, b = 0;
};

/// Holds itself.
struct Endless : public Streamable {
  std::vector<Endless> more;
  void stream(InStream* in, OutStream* out) override { STREAM(more); }
};
REPRESENTATION(HoldsEndless)
class HoldsEndless : public HoldsEndlessBase {
public:
  Endless endless;
  void stream(InStream* in, OutStream* out) override { STREAM(endless); }
};

namespace record {
namespace {

TEST(SchemaTest, knowsTheElementsOfListsThatAreEmpty) {
  const Schema schema = schemaOf(representationLoader<Shapes>());
  EXPECT_EQ(schemaText(schema),
            "{flag:b small:i1 number:f8 text:s place:{x:f8 y:f8} angles:{f8*3} names:[s] points:[{x:f8 y:f8 "
            "z:f8}]}");
  EXPECT_EQ(schemaFromText(schemaText(schema)), schema);
}

TEST(SchemaTest, aBlockOfMemoryHasItsSize) {
  EXPECT_EQ(schemaText(schemaOf(representationLoader<PlainBlock>())), "{r16}");
  EXPECT_EQ(schemaFromText("{r16}"), schemaOf(representationLoader<PlainBlock>()));
}

TEST(SchemaTest, aTypeThatHoldsItselfIsRefused) {
  EXPECT_THROW(schemaOf(representationLoader<HoldsEndless>()), std::runtime_error);
}

TEST(SchemaTest, textThatIsNoFormIsRefused) {
  for (const char* text : {"", "{", "{x}", "[f8 f8]", "[]", "{f8*0}", "{a:}", "f9", "{f8}x", "name:r1",
                           "{{{f8*9999}*9999}*9999}"})
    EXPECT_THROW(schemaFromText(text), std::runtime_error) << text;
  EXPECT_THROW(schemaFromText(std::string(100'000, '{')), std::runtime_error);
}

TEST(RosMessageTest, definitionHasNamesAsRosWantsThem) {
  const Schema schema = schemaFromText(
      "{stepHeight:f8 T_torso_link:[{rotation:{{f8*3}*3} translation:{x:f8}}] xyz:{f4*2} B2:[[u1]]}");
  EXPECT_EQ(messageType("FKModel"), "plumbline_msgs/msg/FKModel");
  EXPECT_EQ(messageDefinition("FKModel", schema),
            "float64 step_height\n"
            "plumbline_msgs/FKModelTTorsoLinkElement[] t_torso_link\n"
            "float32[2] xyz\n"
            "plumbline_msgs/FKModelB2Element[] b2\n" +
                std::string(80, '=') +
                "\nMSG: plumbline_msgs/FKModelTTorsoLinkElement\n"
                "float64[9] rotation\n"
                "plumbline_msgs/FKModelTTorsoLinkElementTranslation translation\n" +
                std::string(80, '=') +
                "\nMSG: plumbline_msgs/FKModelB2Element\n"
                "uint8[] values\n" +
                std::string(80, '=') +
                "\nMSG: plumbline_msgs/FKModelTTorsoLinkElementTranslation\n"
                "float64 x\n");
  EXPECT_EQ(messageDefinition("Empty", Schema{}), "uint8 structure_needs_at_least_one_member\n");
}

}  // namespace
}  // namespace record
}  // namespace plumbline
