# The front door; `make help` tells what there is. What is built, and how, stands in configure.sh.
SHELL := /bin/bash
MAKEFLAGS += -rR --no-print-directory
.DELETE_ON_ERROR:
.SUFFIXES:
.DEFAULT_GOAL := default
comma := ,
Q := $(if $(V),,@)
say = printf '  %-6s%s\n' '$(1)' '$(2)'
CCACHE ?= $(shell command -v ccache)
# What ccache must overlook to serve sources that use a precompiled header.
export CCACHE_SLOPPINESS := $(if $(CCACHE_SLOPPINESS),$(CCACHE_SLOPPINESS)$(comma))pch_defines$(comma)time_macros
export DEBIAN_FRONTEND ?= noninteractive

# As many jobs as cores, unless -j says otherwise.
ifeq (0,$(MAKELEVEL))
ifeq (,$(filter -j% --jobserver%,$(MAKEFLAGS)))
MAKEFLAGS += -j$(or $(JOBS),$(shell nproc))
endif
endif

# ---- targets: those with settings and those configured by hand --------------------------------------------
defaultTarget := $(or $(file <build/default),SimRelease)
knownTargets := $(sort $(patsubst scripts/targets/%.settings,%,$(wildcard scripts/targets/*.settings)) \
  $(patsubst build/%/target.mk,%,$(wildcard build/*/target.mk)))
configuredTargets := $(or $(patsubst build/%/target.mk,%,$(wildcard build/*/target.mk)),$(defaultTarget))

# The targets these goals are about; only they are looked at.
goals := $(or $(MAKECMDGOALS),default)
goalTargets := $(sort $(foreach t,$(knownTargets),$(if $(filter $(t) $(t)-% build/$(t)/%,$(goals)),$(t))) \
  $(if $(filter default,$(goals)),$(defaultTarget)) \
  $(if $(filter bin/% lib/%,$(goals)),SimRelease) \
  $(if $(filter all,$(goals)),$(configuredTargets)))

ifneq (,$(goalTargets))
# Files that came or went since the last time are noticed here.
targets := $(shell ./configure.sh --refresh $(goalTargets))
ifneq (0,$(.SHELLSTATUS))
$(error configuration failed)
endif
include $(foreach t,$(targets),build/$(t)/target.mk)
include $(sort $(targets.makefiles))
$(foreach t,$(targets),$(if $(shell command -v $($(t).cxx)),,$(error no compiler $($(t).cxx) for $(t): `make packages` installs what scripts/packages.txt lists)))
endif

.PHONY: default all help packages run web test bench fuzz results format format-check tidy check clean
default: $(defaultTarget)
all: $(configuredTargets)

help:
	@scripts/make/help.sh "$(defaultTarget)" "$(knownTargets)"

packages:
	@scripts/install_packages.sh

run: packages
	@$(MAKE) SimRelease
	@scripts/build_page.sh --if-easy
	@scripts/run.sh $(ARGS)

web:
	@scripts/build_page.sh

test: packages
	@scripts/install_packages.sh scripts/packages-test.txt
	@scripts/build_page.sh
	+@scripts/run_tests.sh --all

test-%:
	+@scripts/run_tests.sh $*

bench: packages
	@scripts/install_packages.sh scripts/packages-bench.txt
	@$(MAKE) SimRelease-bench
	@scripts/run_bench.sh

bench-%:
	@scripts/install_packages.sh scripts/packages-bench.txt
	@$(MAKE) SimRelease $(if $(wildcard tests/bench/$*.cpp tests/bench/$*/*.cpp),SimRelease-bench-$*)
	@scripts/run_bench.sh $*

# The walk's tables, figures and page (doc/results/walking.md, build/bench/walking.html): all robots, or what ARGS says, as
# ARGS="4 1 20 --robots nao-bullet,type0 --sections speeds,pushes".
bench-walk:
	@scripts/install_packages.sh scripts/packages-bench.txt
	@$(MAKE) SimRelease-bench-walking
	@BENCH_ARGS="$(ARGS)" scripts/run_bench.sh walking
	@scripts/make_results.sh walking
	@cat build/bench/walking.md

# Parts of it with pages of their own, doc/results/walking-nao.md and walking-fit.md: the NAO alone, in Bullet and in
# MuJoCo; the thesis's tables before and after the model is fitted, of all robots.
walk-nao := --robots nao-bullet,nao-mujoco --sections speeds,thesis,estimate
walk-fit := --sections thesis
bench-walk-nao bench-walk-fit: bench-%:
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

# The league's recordings against the simulator with one setting left out; TRACES=FOLDER for other recordings.
# Real robots, whose recordings are not part of the project: DATA=FOLDER, ROBOT and SPLIT for a part. A NAO that walks in
# Bullet, diagnosed by bin/gap from its walks alone: CASES, SEED, JOBS. All write their page in doc/results/.
bench-gap-simspark bench-gap-real bench-gap-walk: bench-%:
	@scripts/install_packages.sh scripts/packages-bench.txt
	@$(MAKE) $(if $(filter gap-walk,$*),SimRelease) SimRelease-bench-$*
	@scripts/run_bench.sh $* || { cat build/bench/$*.log >&2; exit 2; }
	@scripts/make_results.sh $*

fuzz:
	@scripts/install_packages.sh scripts/packages.txt scripts/packages-fuzz.txt
	@$(MAKE) Fuzz
	@scripts/fuzz.sh $(or $(SECONDS),60) $(TARGETS)

results: bench
	@scripts/make_results.sh

check:
	@scripts/check_floors.sh && scripts/check_sizes.sh

format:
	@scripts/format.sh

format-check:
	@scripts/format.sh --check

tidy: packages
	+@scripts/tidy.sh $(FILES)

clean:
	@cat build/*/outputs 2>/dev/null | xargs -r rm -f
	@rm -rf build compile_commands.json
