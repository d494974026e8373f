#include "simspark/SimulatorProcess.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "support/ScratchFolder.h"
#include "support/Thrown.h"

namespace plumbline::simspark {
namespace {

TEST(SimulatorProcess, isNotWaitedForOnceItsOwnerIsStopped) {
  const test::ScratchFolder folder;
  const std::string program = folder / "silent";
  folder.write("silent", "#!/bin/sh\nexec sleep 3600\n");
  std::filesystem::permissions(program, std::filesystem::perms::owner_all);
  int asked = 0;
  EXPECT_EQ(thrownBy([&] {
              SimulatorProcess(program, {}, folder / "ports", folder / "log",
                               [&asked] { return ++asked > 2; });
            }),
            "stopped before " + program + " listened");
  EXPECT_EQ(asked, 3) << "and the hour of the program has not passed";
}

}  // namespace
}  // namespace plumbline::simspark
