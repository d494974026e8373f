#!/usr/bin/env bash
# Prints what make can do. $1: the default target, $2: all targets.
cat << END
make run             install what is missing, build, play one game (ARGS="..." are handed on)
make web             build the page that shows games in 3D (fetches three.js)
make test            install what is missing, build, run every test, under sanitizers too
make                 build the target configured last, now $1
make TARGET          build one target: ${2// /, }
make TARGET-tests    build its test programs as well; TARGET-bench the benchmarks
make all             build every configured target
make test-AREA       build and run the tests of tests/AREA alone
make fuzz            libFuzzer on all that reads from outside, SECONDS=60 of each (TARGETS="..." for some)
make bench           run all benchmarks into build/bench/; bench-AREA those of one area
make results         the same, and write doc/results/ from it
make format, tidy    clang-format and clang-tidy (FILES="..." for some); format-check changes nothing
make check           includes point down the floors, files are short
make packages        install the packages of scripts/packages.txt
make clean           remove what was built
With V=1 commands are shown, with -jN or JOBS=N at most N run at once.
./configure.sh --help tells how a target is made.
END
