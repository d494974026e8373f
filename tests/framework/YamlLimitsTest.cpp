#include "framework/YamlLimits.h"

#include <gtest/gtest.h>

#include "framework/ConfigNode.h"
#include "framework/YamlDocument.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

constexpr const char* fine = "nothing thrown";

std::string said(const std::string& text, const YamlLimits& limits = {}) {
  return thrownBy([&] { checkYamlLimits(text, "a.yaml", limits); });
}

std::string lists(int depth) {
  return std::string(static_cast<std::size_t>(depth), '[') +
         std::string(static_cast<std::size_t>(depth), ']');
}

TEST(YamlLimits, takeWhatPeopleWrite) {
  EXPECT_EQ(said(""), fine);
  EXPECT_EQ(said("a: 1\nb: [1, 2, {c: d}]\n"), fine);
  EXPECT_EQ(said(lists(32)), fine);
  EXPECT_EQ(said("a: &x [1, 2]\nb: *x\nc: [*x, *x]\n"), fine);
}

TEST(YamlLimits, depthIsBounded) {
  EXPECT_EQ(said(lists(33)), "a.yaml:1: nested deeper than 32 levels");
  EXPECT_EQ(said("a:\n  - " + lists(31)), "a.yaml:2: nested deeper than 32 levels");
  EXPECT_EQ(said("a: [1, [2]]\n", {.depth = 2}), "a.yaml:1: nested deeper than 2 levels");
}

TEST(YamlLimits, valuesAreCountedBeforeTheyAreBuilt) {
  EXPECT_EQ(said("[1, 2, 3]", {.values = 5}), fine);  // the document, the list and what is in it
  EXPECT_EQ(said("[1, 2,\n 3, 4]", {.values = 5}), "a.yaml:2: more than 5 values");
  // Half a million lists would be hundreds of megabytes as a tree.
  std::string many = "a: [";
  for (int i = 0; i < 500000; ++i) many += "[],";
  EXPECT_EQ(said(many + "]"), "a.yaml:1: more than 100000 values");
  std::string documents;
  for (int i = 0; i < 200000; ++i) documents += "---\n";
  EXPECT_NE(said(documents).find(": more than 100000 values"), std::string::npos);
}

/// Nine lines that stand for a thousand million values.
TEST(YamlLimits, anAliasCountsAsAllThatItStandsFor) {
  std::string text = "a: &a [x, x, x, x, x, x, x, x, x, x]\n";
  for (char name = 'b'; name < 'j'; ++name) {
    text += std::string(1, name) + ": &" + name + " [";
    for (int i = 0; i < 10; ++i) text += std::string(i ? ", *" : "*") + static_cast<char>(name - 1);
    text += "]\n";
  }
  EXPECT_EQ(said(text), "a.yaml:5: more than 100000 values");
  EXPECT_EQ(said("a: &a [1, 2, 3]\nb: [*a, *a]\n", {.values = 17}), fine);
  EXPECT_EQ(said("a: &a [1, 2, 3]\nb: [*a, *a]\n", {.values = 16}), "a.yaml:2: more than 16 values");
  // Each name stands for one level more.
  std::string deep = "- &l0 [x]\n";
  for (int i = 1; i < 40; ++i) deep += "- &l" + std::to_string(i) + " [*l" + std::to_string(i - 1) + "]\n";
  EXPECT_EQ(said(deep), "a.yaml:32: nested deeper than 32 levels");
}

TEST(YamlLimits, anAliasWithinItselfIsRefused) {
  EXPECT_EQ(said("a: &a [1, *a]\n"), "a.yaml:1: an alias refers to a value that contains it");
}

TEST(YamlLimits, holdForFilesAndValues) {
  EXPECT_EQ(thrownBy([] { parseYaml(lists(40), "b.yaml"); }), "b.yaml:1: nested deeper than 32 levels");
  EXPECT_EQ(thrownBy([] { parseYamlValue("&a [*a]", "walk.speed"); }),
            "walk.speed:1: an alias refers to a value that contains it");
}

/// Whatever stands in a key, the error is one line.
TEST(YamlLimits, aKeyWithControlCharactersIsNoKey) {
  EXPECT_EQ(thrownBy([] { parseYamlValue("{\"a\\nb\": 1}", "value"); }),
            "value:1: a key must be a plain word");
}

}  // namespace
}  // namespace plumbline
