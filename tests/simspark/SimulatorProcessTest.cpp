#include "simspark/SimulatorProcess.h"

#include <gtest/gtest.h>

#include <chrono>
#include <filesystem>

#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline::simspark {
namespace {

TEST(SimulatorProcess, isNotWaitedForOnceItsOwnerIsStopped) {
  const test::ScratchFolder folder;
  const std::string program = folder / "silent";
  folder.write("silent", "#!/bin/sh\nexec sleep 100\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  const auto start = std::chrono::steady_clock::now();
  int asked = 0;
  EXPECT_EQ(thrownBy([&] {
              SimulatorProcess(program, {}, folder / "ports", folder / "log",
                               [&asked] { return ++asked > 2; });
            }),
            "stopped before " + program + " listened");
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(5));
}

}  // namespace
}  // namespace plumbline::simspark
