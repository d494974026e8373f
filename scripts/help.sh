#!/usr/bin/env bash
# Prints what make can do. $1: the default target, $2: all targets.
cat << END
make run             install what is missing, build what one game needs, play it (ARGS="..." are handed on)
make match           eleven against eleven on a page (ARGS="--help" lists the options)
make web             build the page that shows games in 3D (fetches three.js)
make test            install what is missing, build, run every test, under sanitizers too
make                 build the target configured last, now $1
make TARGET          build one target: ${2// /, }
make TARGET-tests    build its test programs as well; TARGET-bench the benchmarks
make all             build every configured target
make test-AREA       build and run the tests of tests/AREA alone
make cluster         Open MPI and Slurm on this machine: installs them, runs the tests of tests/cluster (NAMES="mpi slurm")
make check           everything that takes long: all tests, and the thread sanitizer
make thread          the thread sanitizer over what has threads (AREAS="..." for others)
make coverage        which lines of src/ the tests run, a line per folder (AREAS="..." for some tests)
make mutation        whether tests notice thresholds and operators that are changed (FOLDERS="walking", MOST=20)
make fuzz            libFuzzer on all that reads from outside: SECONDS=20 of each, a quarter of an hour and more (TARGETS="..." for some)
make faults, kills   calls of the system that fail, and kills, in every program (FAULTJOBS="..." for some; KILLS=8, SEED=1)
make stops           SIGINT and SIGTERM in every program, which must end within a second (FAULTJOBS="..."; STOPS=8, SEED=1)
make soak            a long game: memory and cost of simulator and agents (MINUTES=10, AGENTS=22)
make bench           run all benchmarks into build/bench/; bench-AREA those of one area
                     (bench-walk, -walk-nao, -walk-fit, -walk-server, -fidelity, -games, -gap, -gap-real, -gap-speed, -gap-walk,
                     -gap-simspark, -robust, -positioning, -saves, -collisions, -goal, -clients, -optimisation-motions, -optimisation-standup)
make soak-live       an agent for hours with all that looks into it (HOURS=5); part of doc/results/live.md
make results         the same, and write doc/results/ from it
make pictures        make the pictures and sample output of README and doc/ anew
make install         programs, libraries, manual pages (PREFIX=/usr/local, DESTDIR=); make deb: a Debian package
make format, tidy    clang-format and clang-tidy (FILES="..." for some); format-check changes nothing
make packages        install the packages of scripts/packages.txt
make clean           remove what was built
Variables: V=1 shows commands, -jN or JOBS=N at most N at once, CCACHE= without ccache; of the tests,
TEST_CPU_SECONDS=600 and TEST_TIMEOUT=3600; SERVER=, CASES=, SEED=, DATA=: see doc/reference/build.md.
Examples: make run; make test-framework; make SimDebug-tests
./configure.sh --help says how a target is configured.
END
