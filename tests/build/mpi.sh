#!/usr/bin/env bash
# A program that needs MPI is left out where that is not installed, which is said once, and no other program minds.
source "$(dirname "$0")/project.bash"
writeSources
mkdir src/main/carrier
printf '#pragma once\n#include <mpi.h>\n' > src/main/carrier/Ranks.h
printf '#include "Ranks.h"\nint main(int argc, char** argv) { MPI_Init(&argc, &argv); return MPI_Finalize(); }\n' > src/main/carrier/main.cpp
ignored=$(find /usr/include /usr/lib -name mpi.h -printf '%h;' 2> /dev/null)
said=$(./configure.sh --target SimRelease "-DCMAKE_IGNORE_PATH=/usr/include/x86_64-linux-gnu/mpi;$ignored")
expect "configure says what it leaves out" "$said" "bin/carrier is left out: it needs libopenmpi-dev, which make cluster installs
Configured SimRelease. Build it with: make SimRelease"
builds
expect "all others are built" "$(linked)" "bin/agent bin/tool"
build bin/carrier
expect "its own goal: status" "$status" 2
contains "its own goal" "$log" "bin/carrier is left out: it needs libopenmpi-dev, which make cluster installs"
finish
