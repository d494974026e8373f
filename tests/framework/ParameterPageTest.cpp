#include "framework/ParameterPage.h"

#include <gtest/gtest.h>

#include <memory>

#include "framework/Module.h"

namespace plumbline {
namespace {

struct Lean {
  PARAMETERS(Lean)
  PARAMETER(double, share, 0.25, "", Range(0, 1), "how much of it")
};

MODULE(Paged)
  PARAMETER(int, count, 3, "", Range::atLeast(1), "a | b")
  PARAMETER(std::string, name, "x", "", Range(), "its name")
  PARAMETER_CHOICE(way, "left", "where to", "left", "right")
  PARAMETER_GROUP(Lean, forward, "leaning forward")
  PARAMETER_GROUP(Lean, backward, "leaning backward")
END_MODULE
class Paged : public PagedBase {};

/// Known to one registry alone.
class PagedLoader : public ModuleLoader {
public:
  const ModuleDescription& description() const override { return Paged::moduleDescription(); }
  std::unique_ptr<Module> create() const override { return std::make_unique<Paged>(); }
};

TEST(ParameterPage, hasARowForEachParameterAndOneForAGroupThatWasDescribed) {
  const PagedLoader loader;
  Registry registry;
  registry.add(loader);
  const std::string page = parameterPage(registry, {});
  EXPECT_EQ(page.substr(page.find("\n## ")),
            "\n## Paged\n\n| parameter | type | default | unit | range | what it does |\n"
            "|---|---|---|---|---|---|\n"
            "| `count` | int | 3 |  | 1 … ∞ | a \\| b |\n"
            "| `name` | text | x |  |  | its name |\n"
            "| `way` | text | left |  | left, right | where to |\n"
            "| `forward.share` | double | 0.25 |  | 0 … 1 | how much of it |\n"
            "| `backward.` … | | | | | leaning backward: names as above |\n");
}

TEST(ParameterPage, hasTheFilesThatAreNoModules) {
  const std::map<std::string, ParameterFile> files = {
      {"lean", {"How it leans.", &Lean::parameterList(), []() -> std::shared_ptr<void> {
                  return std::make_shared<Lean>();
                }}}};
  const std::string page = parameterPage(Registry(), files);
  EXPECT_EQ(
      page.substr(page.find("\n## ")),
      "\n## lean.yaml\n\nHow it leans.\n\n| parameter | type | default | unit | range | what it does |\n"
      "|---|---|---|---|---|---|\n"
      "| `share` | double | 0.25 |  | 0 … 1 | how much of it |\n");
}

}  // namespace
}  // namespace plumbline
