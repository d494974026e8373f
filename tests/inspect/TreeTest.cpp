#include "inspect/Tree.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "framework/TextStream.h"
#include "inspect/TreeStream.h"

namespace plumbline::inspect {
namespace {

struct Inner {
  double x = 1, y = 2;
  void stream(InStream* in, OutStream* out) {
    STREAM(x);
    STREAM(y);
  }
};
struct Outer {
  Inner point;
  std::vector<int> list{4, 5};
  std::string name = "a \"b\" {";
  bool on = true;
  char sign = '}';
  void stream(InStream* in, OutStream* out) {
    STREAM(point);
    STREAM(list);
    STREAM(name);
    STREAM(on);
    STREAM(sign);
  }
};

Tree treeOf(const Outer& value) {
  Tree tree;
  TreeOutStream out(tree);
  StreamType<Outer>::write(out, value);
  return tree;
}

std::string set(Outer& value, const std::string& path, const std::string& text) {
  Tree tree = treeOf(value), wanted;
  std::string error = parseTree(text, wanted);
  Tree* part = error.empty() ? findPart(tree, path, error) : nullptr;
  if (!part) return error;
  wanted.label = part->label;
  *part = wanted;
  TreeInStream in(tree);
  StreamType<Outer>::read(in, value);
  return in.problem();
}

TEST(TreeTest, theTextFormIsReadAsTheSameTree) {
  const Tree streamed = treeOf({});
  Tree read;
  EXPECT_EQ(parseTree(toText(Outer()), read), "");
  EXPECT_EQ(treeText(read), treeText(streamed));
  EXPECT_EQ(
      treeText(read),
      "{[point] {[x] 1.000000 [y] 2.000000} [list] {4 5} [name] \"a \\\"b\\\" {\" [on] true [sign] '}'}");
  EXPECT_EQ(treeJson(read).dump(),
            R"({"list":[4,5],"name":"a \"b\" {","on":true,"point":{"x":1.0,"y":2.0},"sign":"}"})");
}

TEST(TreeTest, partsAreFoundByPath) {
  Tree tree = treeOf({});
  std::string error;
  EXPECT_EQ(treeText(*findPart(tree, ".point.y", error)), "2.000000");
  EXPECT_EQ(treeText(*findPart(tree, ".list[1]", error)), "5");
  EXPECT_EQ(treeText(*findPart(tree, ".point", error)), "{[x] 1.000000 [y] 2.000000}");
  const auto problem = [&](const char* path) {
    EXPECT_EQ(findPart(tree, path, error), nullptr);
    return error;
  };
  EXPECT_EQ(problem(".pint"), " has no part pint; it has point, list, name, on, sign");
  EXPECT_EQ(problem(".point.z"), ".point has no part z; it has x, y");
  EXPECT_EQ(problem(".point.x.a"), ".point.x is a single value and has no part a");
  EXPECT_EQ(problem(".list[2]"), ".list has no element [2]; it has 2");
  EXPECT_EQ(problem(".list[-1]"), ".list an element's number must be in [], not \"-1\"");
  EXPECT_EQ(problem(".list.a"), ".list is a list of 2; its elements are [0], [1], ...");
  EXPECT_EQ(problem(".on[0]"), ".on is a single value and has no element [0]");
  EXPECT_EQ(problem(".list[0"), ".list parts are written .name or [number], not \"[0\"");
}

TEST(TreeTest, whatIsNoValueIsAnErrorInOneLine) {
  Tree tree;
  EXPECT_EQ(parseTree("", tree), "a value is missing");
  EXPECT_EQ(parseTree("{1", tree), "a } is missing");
  EXPECT_EQ(parseTree("1 2", tree), "text left over: \"2\"");
  EXPECT_EQ(parseTree("}", tree), "a } without {");
  EXPECT_EQ(parseTree("\"abc", tree), "a closing quote is missing");
  EXPECT_EQ(parseTree("[a", tree), "a label has no ]");
  EXPECT_EQ(parseTree("a\"b", tree), "unexpected \"\"b\"");
  EXPECT_EQ(parseTree(std::string(100000, '{'), tree), "nested too deeply");
}

TEST(TreeTest, aPartIsSetAndTheRestStays) {
  Outer value;
  EXPECT_EQ(set(value, ".point.x", "7.5"), "");
  EXPECT_EQ(set(value, ".list[0]", "9"), "");
  EXPECT_EQ(set(value, ".name", "word"), "");
  EXPECT_EQ(value.point.x, 7.5);
  EXPECT_EQ(value.point.y, 2);
  EXPECT_EQ(value.list, (std::vector{9, 5}));
  EXPECT_EQ(value.name, "word");
  EXPECT_EQ(set(value, ".list", "{1 2 3}"), "");
  EXPECT_EQ(value.list.size(), 3u);
  EXPECT_EQ(set(value, ".point", "{[whatever] 3 4}"), "");
  EXPECT_EQ(value.point.y, 4);
}

TEST(TreeTest, aWrongValueIsNamedWithItsPlace) {
  Outer value;
  EXPECT_EQ(set(value, ".point.x", "far"), "point.x: expected a number, found \"far\"");
  EXPECT_EQ(set(value, ".point.x", "nan"), "point.x: must be finite, not nan");
  EXPECT_EQ(set(value, ".point.x", "{1}"), "point.x: expected a single value, found a group");
  EXPECT_EQ(set(value, ".point", "3"), "point: expected values in {}, found \"3\"");
  EXPECT_EQ(set(value, ".point", "{3}"), "point.y: a value is missing");
  EXPECT_EQ(set(value, ".point", "{3 4 5}"), "point: holds 1 value too many");
  EXPECT_EQ(set(value, ".list[0]", "1.5"), "list: expected an integer of 4 bytes, found \"1.5\"");
  EXPECT_EQ(set(value, ".on", "maybe"), "on: expected true or false, found \"maybe\"");
}

}  // namespace
}  // namespace plumbline::inspect
