# The front door; `make help` lists the targets. Behind it is CMake: CMakeLists.txt, CMakePresets.json.
SHELL := /bin/bash
MAKEFLAGS += -rR --no-print-directory
.SUFFIXES:
.DEFAULT_GOAL := default
.NOTPARALLEL:
comma := ,
export DEBIAN_FRONTEND ?= noninteractive
# As many jobs as cores, unless -j or JOBS says otherwise.
JOBS ?= $(or $(patsubst -j%,%,$(filter -j%,$(MAKEFLAGS))),$(shell nproc))
export JOBS V
ifneq (undefined,$(origin CCACHE))
export CCACHE
endif

# ---- targets: the presets -----------------------------------------------------------------------------------
defaultTarget := $(or $(file <build/default),SimRelease)
knownTargets := $(shell scripts/list_targets.sh)
configuredTargets := $(or $(patsubst build/%/cmake/build.ninja,%,$(wildcard build/*/cmake/build.ninja)),$(defaultTarget))

.PHONY: $(knownTargets)
$(knownTargets):
	@scripts/build.sh $@ $(if $(filter Fuzz,$@),fuzz)

define targetRules
$(1)-%:
	@scripts/build.sh $(1) $$(if $$(filter tests bench,$$*),all) $$*
build/$(1)/tests/%: force
	@scripts/build.sh $(1) test-$$*
build/$(1)/bench/%: force
	@scripts/build.sh $(1) bench-$$*
endef
$(foreach t,$(knownTargets),$(eval $(call targetRules,$(t))))
bin/%: force
	@scripts/build.sh SimRelease $*
.PHONY: force

.PHONY: default all help packages run match web pictures test cluster bench fuzz faults kills stops soak thread coverage mutation install deb results format format-check tidy check clean bench-live soak-live
default: $(defaultTarget)
all: $(configuredTargets)

help:
	@scripts/help.sh "$(defaultTarget)" "$(knownTargets)"

packages:
	@scripts/install_packages.sh

run: packages
	@scripts/build.sh SimRelease agent simulator game
	@scripts/build_page.sh --if-easy
	@scripts/run.sh $(ARGS)

# Eleven against eleven on a page; ARGS="--help" lists the options.
match: packages
	@$(MAKE) SimRelease
	@scripts/build_page.sh --if-easy
	@scripts/match.sh $(ARGS)

web:
	@scripts/build_page.sh

# The pictures and the sample output of README and doc/, by the commands that stand beside them.
pictures: packages
	@scripts/install_packages.sh scripts/packages-test.txt scripts/packages-bench.txt
	@$(MAKE) SimRelease SimRelease-bench-walking
	@scripts/build_page.sh
	@scripts/make_pictures.sh $(ARGS)

test: packages
	@scripts/install_packages.sh scripts/packages-test.txt
	@scripts/build_page.sh
	+@scripts/run_tests.sh --all

test-%:
	+@scripts/run_tests.sh $*

# What runs on clusters, on this machine: Open MPI, network namespaces and a Slurm of its own. NAMES="mpi slurm" for some.
cluster: packages
	@RUNLEVEL=1 scripts/install_packages.sh scripts/packages-cluster.txt
	@scripts/build.sh SimRelease optserver optworker mpitunnel
	@scripts/cluster_tests.sh $(NAMES)

bench: packages
	@scripts/install_packages.sh scripts/packages-bench.txt
	@$(MAKE) SimRelease-bench
	@scripts/run_bench.sh

bench-%:
	@scripts/install_packages.sh scripts/packages-bench.txt
	@$(MAKE) SimRelease $(if $(wildcard tests/bench/$*.cpp tests/bench/$*/*.cpp),SimRelease-bench-$*)
	@scripts/run_bench.sh $*

# What looking into a running agent costs: doc/results/live.md.
bench-live:
	@scripts/install_packages.sh scripts/packages-bench.txt
	@$(MAKE) SimRelease SimRelease-bench-live SimRelease-bench-network
	@scripts/run_bench.sh live
	@scripts/make_results.sh live

# An agent that plays for HOURS simulated hours with all of that switched on: memory and processor time, first and last.
HOURS ?= 0.1
soak-live:
	@$(MAKE) SimRelease
	@scripts/build_page.sh
	@scripts/soak_live.sh $(HOURS)
	@scripts/make_results.sh live

# The walk's tables, figures and page (doc/results/walking.md, build/bench/walking.html): all robots, or what ARGS says, as
# ARGS="4 1 20 --robots nao-bullet,type0 --sections speeds,pushes".
bench-walk:
	@scripts/install_packages.sh scripts/packages-bench.txt
	@$(MAKE) SimRelease-bench-walking
	@BENCH_ARGS="$(ARGS)" scripts/run_bench.sh walking
	@scripts/make_results.sh walking
	@cat build/bench/walking.md

# Parts of it with pages of their own, doc/results/walking-nao.md, walking-fit.md and walking-speeds.md: the NAO alone, in Bullet and
# in MuJoCo; the thesis's tables before and after the model is fitted, of all robots; how fast the league's robots are.
walk-nao := --robots nao-bullet,nao-mujoco --sections speeds,thesis,estimate
walk-fit := --sections thesis
walk-speeds := --sections speeds --robots type0,type1,type2,type3,type4
bench-walk-nao bench-walk-fit bench-walk-speeds: bench-%:
	@scripts/install_packages.sh scripts/packages-bench.txt
	@$(MAKE) SimRelease-bench-walking
	@build/SimRelease/bench/walking $(or $(ARGS),10 10 100) --name $(subst walk,walking,$*) $($*)
	@scripts/make_results.sh $(subst walk,walking,$*)

# The same speeds and tables on a SimSpark server that runs already and waits for its agents ($agentSyncMode = true and
# $enableRealTimeMode = false of the league's, or bin/simulator --sync): SERVER=HOST:AGENTPORT:MONITORPORT for another one
# than this machine's usual one. Writes doc/results/walking-server.md.
SERVER ?= server
serverRobots := type0 type0_plain type1 type2 type3 type3_plain type4
bench-walk-server:
	@scripts/install_packages.sh scripts/packages-bench.txt
	@$(MAKE) SimRelease-bench-walking
	@build/SimRelease/bench/walking $(or $(ARGS),10 1 100) --jobs 1 --name walking-server --sections speeds,thesis \
	  --robots $(subst $() $(),$(comma),$(addsuffix @$(SERVER),$(serverRobots)))
	@scripts/make_results.sh walking-server

# Stand-ups and kicks there, beside the same tries on the embedded simulator: SERVER, TRIES, SEED, TYPES="0 4", MOTIONS="kickLong". Writes
# doc/results/motion-server.md.
bench-motion-server:
	@scripts/install_packages.sh scripts/packages-bench.txt
	@scripts/build.sh SimRelease bench-motion-server
	@SERVER=$(SERVER) scripts/run_bench.sh motion-server || { cat build/bench/motion-server.log >&2; exit 2; }
	@scripts/make_results.sh motion-server

# The whole table, line by line, is what one wants to see of this one.
bench-fidelity:
	@$(MAKE) SimRelease SimRelease-bench-fidelity
	@scripts/run_bench.sh fidelity > build/bench/fidelity.sum; status=$$?; cat build/bench/fidelity.log; exit $$status

# Diagnoses sealed cases made in MuJoCo, a program of its own, beside simpler ways: CASES=200 for the full set, SEED for
# another one, SET for a folder made before, BASELINES=n for the simpler ways on every n-th case, JOBS at a time.
bench-gap:
	@scripts/install_packages.sh scripts/packages-bench.txt
	@$(MAKE) SimRelease SimRelease-bench-gap SimRelease-bench-mujoco
	@scripts/run_bench.sh gap

# bin/gap beside other ways of fitting, on recordings of real robots and tested on others; writes doc/results/gap-peers.md.
# DATA=FOLDER, SPLIT and METHODS for a part.
bench-gap-peers:
	@scripts/build.sh SimRelease gap bench-gap-peers
	@scripts/run_bench.sh gap-peers || { cat build/bench/gap-peers.log >&2; exit 2; }
	@scripts/make_results.sh gap-peers

# CPU time of bin/gap diagnose on four simulated robots; writes doc/results/gap-speed.md. SEED, CASE=joint for one of them.
bench-gap-speed:
	@scripts/build.sh SimRelease gap
	@scripts/run_bench.sh gap-speed || { cat build/bench/gap-speed.log >&2; exit 2; }
	@scripts/make_results.sh gap-speed

# Causes taken out of the nominal model of real recordings, to be named by bin/gap: SEED, CASES, MOTIONS, GAINS; DATA=FOLDER.
bench-gap-planted:
	@$(MAKE) SimRelease SimRelease-bench-gap-planted
	@scripts/run_bench.sh gap-planted || { cat build/bench/gap-planted.log >&2; exit 2; }
	@scripts/make_results.sh gap-planted

# The walk trained with what bin/gap found on a robot, beside one trained without: ROBOTS, SEED, JOBS, ENGINE of the robots. bin/gap
# next on pairs of explanations: PAIRS, SEED. Write doc/results/gap-train.md and gap-next.md.
bench-gap-train bench-gap-next: bench-%:
	@$(if $(filter gap-train,$*),scripts/install_packages.sh scripts/packages-bench.txt)
	@scripts/build.sh SimRelease gap optimizewalk bench-$*
	@scripts/run_bench.sh $* || { cat build/bench/$*.log >&2; exit 2; }
	@scripts/make_results.sh $*

# The league's recordings against the simulator with one setting left out; TRACES=FOLDER for other recordings.
# Real robots, whose recordings are not part of the project: DATA=FOLDER, ROBOT and SPLIT for a part. A NAO that walks in
# Bullet, diagnosed by bin/gap from its walks alone: CASES, SEED, JOBS. All write their page in doc/results/.
bench-gap-simspark bench-gap-real bench-gap-walk: bench-%:
	@scripts/install_packages.sh scripts/packages-bench.txt
	@$(MAKE) $(if $(filter gap-walk,$*),SimRelease) SimRelease-bench-$*
	@scripts/run_bench.sh $* || { cat build/bench/$*.log >&2; exit 2; }
	@scripts/make_results.sh $*

# A kick and a stand-up searched with and without drawn robots, tried on another engine and on others (SUBJECTS, SEEDS,
# TRIES, JOBS, WORKERS); kick positioning from random places (TRIES, SEED, TYPES); shots at a keeper (SHOTS, SEED,
# TYPES); three against three before a goal (TRIES, SEED, BEFORE=FOLDER of an earlier state); collisions with and
# without path planning (GAMES, HALF, SEED, JOBS); set pieces (TRIES, SEED, PLAYERS, OTHERS); what players believe
# (GAMES, HALF, SEED, PLAYERS); searches by 1 to 30 workers (SLEEP); how fast a foot is and could be in a kick
# (BENCH_ARGS=KICKS); the game of `make run` with many seeds (SEEDS, SEED, TYPES, BEFORE=FOLDER); the thesis's tables of
# motions by hand and found (TRIES, TYPES); a search of a stand-up against the clock (MINUTES, TYPE); how long builds
# take, and `make run` in an empty Debian; what each constant of the diagnosis changes in its answers (DATA, FIT,
# TESTS). All write their page in doc/results/.
benchBuilds-robust := optserver optworker
benchBuilds-clients := optserver optworker
benchBuilds-optimisation-motions := optserver
benchBuilds-optimisation-standup := optserver optworker
benchBuilds-saves := agent simulator watchgame
benchBuilds-collisions := agent simulator watchgame
benchBuilds-duels := agent simulator bench-duels
benchBuilds-set-pieces := agent simulator bench-duels
benchBuilds-beliefs := agent simulator watchgame
benchBuilds-kick-limit := bench-kick-limit
buildThemselves := build fresh gap-sensitivity
ownPage := build fresh gap-sensitivity robust positioning saves duels collisions set-pieces beliefs clients kick-limit goal optimisation-motions optimisation-standup
$(ownPage:%=bench-%): bench-%:
	@$(if $(filter $*,$(buildThemselves)),,scripts/build.sh SimRelease $(or $(benchBuilds-$*),agent game simulator))
	@scripts/run_bench.sh $* || { cat build/bench/$*.log >&2; exit 2; }
	@scripts/make_results.sh $*

# The team against the players of before it, in whole games on the embedded simulator: GAMES, HALF (seconds), SEED, JOBS at once.
# Writes doc/results/games.md. With OTHER="COMMAND", and PLAYERS of each side, only games against that team; prints their
# table, or writes it into doc/results/games-peers.md if OTHER_NAME says what the team is called. SERVER=rcssserver3d plays them
# on the league's server, REALTIME=1 in real time.
bench-games: SERVER := $(filter-out server,$(SERVER))
bench-games: export OTHER := $(OTHER)
bench-games: export OTHER_NAME := $(OTHER_NAME)
bench-games:
	@scripts/install_packages.sh scripts/packages-bench.txt
	@scripts/build.sh SimRelease agent game simulator watchgame
	@$(foreach v,GAMES HALF SEED BEFORE PLAYERS SERVER REALTIME,$(if $($v),$v=$($v))) $(if $(OTHER),tests/bench/games/games.sh,scripts/run_bench.sh games)
	@$(if $(OTHER),$(if $(OTHER_NAME),scripts/make_results.sh games-peers),scripts/make_results.sh games)

fuzz:
	@scripts/install_packages.sh scripts/packages.txt scripts/packages-fuzz.txt
	@$(MAKE) Fuzz
	@scripts/fuzz.sh $(if $(KEEP),--keep) $(or $(SECONDS),20) $(TARGETS)

# What happens when a call of the system fails, when a program is killed or stopped, and in long games: doc/results/reliability.md.
# FAULTJOBS="gap_record ..." for some jobs, KILLS=1000 or STOPS=100 of each, SEED for both, MINUTES and AGENTS for the game.
faults kills stops:
	@$(MAKE) SimRelease
	@scripts/build_page.sh
	@$(foreach v,KILLS STOPS SEED MOST ALLOCATIONS,$(if $($v),$v=$($v))) scripts/$@.sh $(FAULTJOBS)

soak:
	@scripts/build.sh SimRelease agent simulator
	@$(foreach v,AGENTS SEED,$(if $($v),$v=$($v))) scripts/soak.sh $(MINUTES)

results: bench
	@scripts/make_results.sh

check:
	@scripts/check_floors.sh && scripts/check_sizes.sh && scripts/check_sentences.sh
	@scripts/install_packages.sh scripts/packages.txt scripts/packages-test.txt
	@scripts/build_page.sh
	@PLUMBLINE_SLOW=1 scripts/run_tests.sh --all
	@$(MAKE) thread
	@scripts/sanitized_programs.sh
	@scripts/faults.sh
	@scripts/kills.sh
	@scripts/stops.sh
	@scripts/soak.sh

# The programs and libraries for this machine: PREFIX=FOLDER for another than configured [/usr/local], DESTDIR=FOLDER for a
# root of its own; and as a Debian package.
install deb: packages
	@scripts/install_packages.sh scripts/packages-install.txt
	@scripts/build.sh SimRelease
	@scripts/make_man.sh
	@$($@Command) > build/SimRelease/$@.log || { tail -5 build/SimRelease/$@.log >&2; exit 2; }
	@echo "$@: what went where is in build/SimRelease/$@.log"
installCommand = cmake --install build/SimRelease/cmake $(if $(PREFIX),--prefix "$$(realpath -ms -- "$(PREFIX)")")
debCommand = cpack --config build/SimRelease/cmake/CPackConfig.cmake

thread: packages
	@scripts/run_tests.sh SimThread $(or $(AREAS),framework inspect dds record pages web optimization tunnel watch)

coverage: packages
	@scripts/coverage.sh $(AREAS)
	@scripts/coverage.sh --report

# Whether the tests notice wrong code: one changed place of src/ at a time. FOLDERS="walking gap/replay" for some, MOST, SEED,
# OPERATORS, LONG and QUICK: scripts/mutation.sh --help. Goes on where it was ended; writes doc/results/mutation.md.
mutation: packages
	@$(foreach v,MOST SEED OPERATORS LONG QUICK,$(if $($v),$v=$($v))) scripts/mutation.sh $(FOLDERS)
	@$(foreach v,SEED OPERATORS,$(if $($v),$v=$($v))) scripts/mutation.sh --report

format:
	@scripts/format.sh

format-check:
	@scripts/format.sh --check

tidy: packages
	+@scripts/tidy.sh $(FILES)

# Anything else: what there is.
.DEFAULT:
	@echo "make: no target '$@'; targets are $(knownTargets), and \`make help\` lists them" >&2; exit 2

clean:
	@for program in build/SimRelease/cmake/links/plumbline-*; do rm -f "bin/$${program##*/plumbline-}"; done
	@rm -rf build compile_commands.json
