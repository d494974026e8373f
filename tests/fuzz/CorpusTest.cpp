#include "fuzz/Corpus.h"

#include <gtest/gtest.h>

#include "fuzz/Readers.h"
#include "support/Thrown.h"

namespace plumbline::fuzz {
namespace {

TEST(Corpus, readsInputsOfAnyBytes) {
  const std::string path = scratchFile("any.inputs", std::string("3\na\nb\n0\n\n2\n\0\n\n", 14));
  EXPECT_EQ(packedInputs(path), (std::vector<std::string>{"a\nb", "", std::string("\0\n", 2)}));
}

TEST(Corpus, saysWhereAFileIsCutOff) {
  for (const std::string_view rest : {"7\nabc\n", "3\nabc", "3", "x\nabc\n", "3 \nabc\n", "-1\nabc\n",
                                      "18446744073709551615\nabc\n", "4\nabc\n"}) {
    const std::string path = scratchFile("cut.inputs", "1\na\n" + std::string(rest));
    EXPECT_EQ(thrownBy([&] { packedInputs(path); }), path + ": no whole input at byte 4") << rest;
  }
}

TEST(Corpus, takesWhatWasFoundAndWhatWasLearnt) {
  const std::string folder = scratchFolder() + "/kept";
  scratchFile("kept/json.inputs", "2\n{}\n");
  scratchFile("kept/found/json-deep", "[[");
  scratchFile("kept/found/jsonlines-cut", "not of it");
  EXPECT_EQ(keptInputs(folder, "json"), (std::vector<std::string>{"{}", "[["}));
  EXPECT_EQ(keptInputs(folder, "jsonlines"), std::vector<std::string>{"not of it"});
  EXPECT_TRUE(keptInputs(folder, "yaml").empty());
  EXPECT_TRUE(keptInputs(folder + "/none", "json").empty());
}

}  // namespace
}  // namespace plumbline::fuzz
