#!/usr/bin/env bash
# `make install` into a scratch folder, with PREFIX and DESTDIR: programs that run there, manual pages, completion, and a project
# outside the tree that links the components one by one.
source "$(dirname "$0")/../e2e/assert.bash"
[[ $bin == "$PWD/bin" ]] || bin=$PWD/bin
prefix="$scratch/opt plumbline"
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES V PREFIX DESTDIR
if scripts/install_packages.sh scripts/packages-install.txt > "$scratch/log" 2>&1; then
  make install PREFIX="$prefix" > "$scratch/log" 2>&1 || fail "make install: $(tail -3 "$scratch/log")"
  make install PREFIX=/usr DESTDIR="$scratch/root" > "$scratch/log" 2>&1 || fail "make install with DESTDIR: $(tail -3 "$scratch/log")"
  [[ ! -e /usr/bin/plumbline-gap || /usr/bin/plumbline-gap -ot $scratch/log ]] || fail "DESTDIR did not keep it out of /usr"
  # All that is in one is in the other; what names the place itself may differ.
  cmp <(cd "$prefix" && find . | sort) <(cd "$scratch/root/usr" && find . | sort) || fail "DESTDIR has other files than PREFIX"
  [[ $(ls "$scratch/root") == usr ]] || fail "outside of PREFIX: $(ls "$scratch/root")"
  [[ $("$scratch/root/usr/bin/plumbline-gap" effects --robot so101) == *'on so101'* ]] || fail "gap does not run in DESTDIR"

  # A manual page for each program, with its name, what it does and examples.
  for program in "$prefix"/lib/plumbline/bin/*; do
    [[ $program != *.sh ]] || continue
    name=plumbline-${program##*/}
    page=$prefix/share/man/man1/$name.1
    grep -qi "^\.TH ${name^^} " "$page" || fail "$page: no heading of $name"
    grep -q "^$name "'\\- .' "$page" || fail "$page does not say what $name does"
    grep -qi '^\(\.S[HS] "\?\)\?example' "$page" || fail "$page has no examples"
    ! command -v man > /dev/null || MANWIDTH=80 man -l "$page" 2>&1 | grep -q . || fail "man does not show $page"
  done
else
  echo "without manual pages: $(tail -1 "$scratch/log")"
  cmake --install build/SimRelease/cmake --prefix "$prefix" > "$scratch/log" || fail "install: $(tail -3 "$scratch/log")"
fi

# Programs find each other and their configuration from any folder.
cd "$scratch"
"$prefix/bin/plumbline-game" --seed 3 --limit 1 --output "$scratch/run" > game.txt 2>&1 || [[ $? == 1 ]] || fail "game: $(cat game.txt)"
grep -q 'no goal within 1 s' game.txt || fail "an installed game says: $(cat game.txt)"
[[ -f $prefix/share/plumbline/config/platforms/simspark/modules.cfg ]] || fail "no configuration"
[[ ! -e $prefix/include/plumbline/main ]] || fail "programs' headers are installed"

# Completion knows a program's options and subcommands.
PATH="$prefix/bin:$PATH"
source "$prefix/share/bash-completion/completions/plumbline-gap"
complete_words() { COMP_WORDS=("$@") COMP_CWORD=$(($# - 1)) COMPREPLY=(); _plumbline; echo "${COMPREPLY[*]}"; }
[[ $(complete_words plumbline-game --se) == --seed ]] || fail "completion of --se: $(complete_words plumbline-game --se)"
[[ " $(complete_words plumbline-gap dia) " == *" diagnose "* ]] || fail "completion of dia: $(complete_words plumbline-gap dia)"
for program in "$prefix"/lib/plumbline/bin/*; do
  [[ $program == *.sh ]] || complete -p "plumbline-${program##*/}" > /dev/null 2>&1 || fail "no completion of plumbline-${program##*/}"
done
[[ " $(complete_words plumbline-gap diagnose --js) " == *" --json "* ]] || fail "completion of --js: $(complete_words plumbline-gap diagnose --js)"

# The examples, each with one component alone.
cp -r "$OLDPWD/doc/examples/library" "$scratch/example"
cmake -S "$scratch/example" -B "$scratch/example/build" -G Ninja "-DCMAKE_PREFIX_PATH=$prefix" > "$scratch/log" 2>&1 || fail "example: $(cat "$scratch/log")"
cmake --build "$scratch/example/build" -j "${JOBS:-2}" > "$scratch/log" 2>&1 || fail "example: $(tail -20 "$scratch/log")"
use() { "$scratch/example/build/use_$1" "${@:2}"; }
expectEqual "$(use framework)" BallModel framework
expectEqual "$(use optimization)" "found: yes" optimization
expectEqual "$(use walking)" "0.1168 m/s" walking
expectEqual "$(use simulation "$prefix/share/plumbline/config")" "after 1.0 s it stands" simulation
expectEqual "$(use gap)" "many, backlash known" gap
! ldd "$scratch/example/build/use_walking" | grep -q libode || fail "walking alone brings ODE along"

# A component that is not there is an error.
! cmake -S "$scratch/example" -B "$scratch/other" -G Ninja "-DCMAKE_PREFIX_PATH=$prefix" -Dcomponents=moon > "$scratch/log" 2>&1 || fail "component moon is there"
grep -q "no component 'moon'" "$scratch/log" || fail "component moon: $(cat "$scratch/log")"
