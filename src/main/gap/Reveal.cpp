// bin/gap reveal: opens the secret that bin/gap record --secret sealed.
#include <cstdio>
#include <filesystem>
#include <memory>
#include <stdexcept>

#include "framework/FileLines.h"
#include "gap/record/Secret.h"
#include "main/gap/Commands.h"

namespace plumbline::gap {

namespace {

void reveal(const std::string& folder) {
  const std::string path = (std::filesystem::path(folder) / "SECRET").string();
  std::string sealed;
  if (!std::filesystem::exists(path) || !FileLines(path).next(sealed))
    throw std::runtime_error(folder + ": no secret there; bin/gap record --secret writes one");
  try {
    std::fputs(unseal(sealed).c_str(), stdout);
  } catch (const std::invalid_argument& error) {
    throw std::runtime_error(path + " " + error.what());
  }
}

}  // namespace

void addReveal(CommandLine& app) {
  auto folder = std::make_shared<std::string>();
  CommandLine command = app.command("reveal", "Prints the secret effect of runs recorded with --secret");
  command.option("folder", *folder, "The folder that bin/gap record wrote").required();
  command.footer("Example:\n  bin/gap reveal runs");
  command.whenChosen([folder] { reveal(*folder); });
}

}  // namespace plumbline::gap
