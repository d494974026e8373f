#include "situation/SituationPage.h"

#include <gtest/gtest.h>

#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline {
namespace {

TEST(SituationPage, showsSituationsByDeciderAndName) {
  const test::ScratchFolder scratch;
  scratch.write("b.yaml", "about: Second.\ndecides: block\nball: [0, 0]\nexpected: {opponent: 0}\n");
  scratch.write(
      "call/a.yaml",
      "about: \"Third_one\"\ndecides: passCall\nrobot: [0, 0, 0]\nball: [0, 0]\nexpected: {asks: true}\n");
  scratch.write("a.yaml", "about: First.\ndecides: block\nball: [0, 0]\n");
  scratch.write("notes.txt", "no situation");
  const auto entries = situationsIn(scratch.path());
  ASSERT_EQ(entries.size(), 3u);
  EXPECT_EQ(entries[2].name, "call-a");
  const std::string page = situationPage(entries, "../img/situations", "bin/this");
  const std::size_t begin = page.find("\n## ");
  EXPECT_NE(page.find("This page is made by `bin/this`."), std::string::npos);
  EXPECT_EQ(page.substr(begin),
            "\n## Blocks: which opponent, and from where\n"
            "\n### a\n\nFirst.\n\n![a](../img/situations/a.svg)\n"
            "\nExpected: not written yet. File: `" +
                scratch.path() +
                "/a.yaml`\n"
                "\n### b\n\nSecond.\n\n![b](../img/situations/b.svg)\n"
                "\nExpected: nobody is blocked. File: `" +
                scratch.path() +
                "/b.yaml`\n"
                "\n## Pass mode: whether the referee is asked for it\n"
                "\n### a\n\nThird\\_one\n\n![call-a](../img/situations/call-a.svg)\n"
                "\nExpected: asks for pass mode. File: `" +
                scratch.path() + "/call/a.yaml`\n");
}

TEST(SituationPage, aFolderWithoutSituationsIsAnError) {
  const test::ScratchFolder scratch;
  EXPECT_EQ(thrownBy([&] { situationsIn(scratch.path()); }),
            scratch.path() + ": no situation there, that is no file NAME.yaml");
}

}  // namespace
}  // namespace plumbline
