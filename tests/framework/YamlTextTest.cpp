#include "framework/YamlText.h"

#include <gtest/gtest.h>

#include "framework/YamlDocument.h"

namespace plumbline {
namespace {

TEST(YamlText, readsBackAsTheSameText) {
  for (const char* text :
       {"", "plain", "a \"quoted\" word", "back\\slash", "key: value # no comment", "- [1, 2]"})
    EXPECT_EQ(parseYaml("text: " + yamlText(text), "test")["text"].as<std::string>(), text);
}

TEST(YamlText, controlCharactersBecomeBlanks) { EXPECT_EQ(yamlText("two\nlines\t"), "\"two lines \""); }

}  // namespace
}  // namespace plumbline
