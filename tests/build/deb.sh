#!/usr/bin/env bash
# `make deb`: what the package says of itself and holds, and programs that run from where it was unpacked.
[[ ${PLUMBLINE_SLOW-} ]] || { echo "left out: it makes a package of all programs; make check runs it"; exit 0; }
source "$(dirname "$0")/../e2e/assert.bash"
unset MAKEFLAGS MFLAGS MAKELEVEL MAKEOVERRIDES V
if ! scripts/install_packages.sh scripts/packages-install.txt > "$scratch/log" 2>&1; then
  echo "left out: $(tail -1 "$scratch/log")"
  exit 0
fi
rm -f build/SimRelease/plumbline_*.deb
make deb > "$scratch/log" 2>&1 || fail "make deb: $(tail -20 "$scratch/log")"
packages=(build/SimRelease/plumbline_*.deb)
expectEqual "${#packages[@]}" 1 "packages"
package=${packages[0]}
[[ -f $package ]] || fail "no package in build/SimRelease: $(cat "$scratch/log")"

# What it says of itself.
field() { dpkg-deb --field "$package" "$1"; }
dpkg-deb --info "$package" > "$scratch/info" || fail "dpkg-deb --info"
version=$(sed -n 's/^project(Plumbline VERSION \([0-9.]*\).*/\1/p' CMakeLists.txt)
[[ $version ]] || fail "CMakeLists.txt names no version"
expectEqual "$(field Package)" plumbline "the name"
expectEqual "$(field Version)" "$version" "the version"
expectEqual "$(field Architecture)" "$(dpkg --print-architecture)" "the architecture"
expectEqual "${package##*/}" "plumbline_${version}_$(field Architecture).deb" "the file's name"
[[ $(field Maintainer) == *@* && $(field Description) && $(field Section) == science ]] || fail "it says too little: $(cat "$scratch/info")"
(($(field Installed-Size) > 10000)) || fail "installed, it has $(field Installed-Size) KiB"

# It depends on what its programs load, by names that this Debian has.
depends=$(field Depends)
mapfile -t names < <(tr ',|' '\n\n' <<< "$depends" | sed 's/(.*//; s/ //g' | sort -u)
((${#names[@]} > 5)) || fail "it depends on: $depends"
[[ " ${names[*]} " == *" libc6 "* ]] || fail "it depends on: $depends"
for name in "${names[@]}"; do
  apt-cache show "$name" > /dev/null 2>&1 || fail "this Debian has no package $name: $depends"
  [[ $name != *-dev ]] || fail "it depends on $name, which is for building"
done

# What it holds.
dpkg-deb --contents "$package" > "$scratch/contents" || fail "dpkg-deb --contents"
holds() { grep -qE " \./$1( ->.*)?\$" "$scratch/contents" || fail "it has no $1"; }
count=0
for program in bin/*; do
  [[ -x $program && $program != *.sh ]] || continue
  name=${program##*/}
  holds "usr/bin/plumbline-$name"
  holds "usr/lib/plumbline/bin/$name"
  holds "usr/share/man/man1/plumbline-$name\.1"
  holds "usr/share/bash-completion/completions/plumbline-$name"
  count=$((count + 1))
done
((count > 10)) || fail "bin/ has $count programs"
for path in bin/plumbline-{start,kill} share/plumbline/config/field.yaml share/plumbline/config/robots/nao_v5.json \
  share/plumbline/config/platforms/simspark/modules.cfg share/doc/plumbline/LICENSE lib/cmake/Plumbline/PlumblineConfig.cmake \
  include/plumbline/framework/Module.h lib/libplumbline_framework.a; do
  holds "usr/$path"
done
strange=$(awk '{ print $6 }' "$scratch/contents" | grep -vE '^\./(usr/((bin|lib|share|include)(/.*)?)?)?$' || true)
[[ -z $strange ]] || fail "it has files where none belong: $strange"
awk '$2 != "root/root" { print; bad = 1 } END { exit bad }' "$scratch/contents" > "$scratch/log" || fail "not root's: $(head -3 "$scratch/log")"

# Unpacked, programs run there, and find each other and their configuration.
root=$scratch/un\ packed
dpkg-deb -x "$package" "$root" || fail "dpkg-deb -x"
cd "$scratch"
expectEqual "$("$root/usr/lib/plumbline/bin/agent" --version)" "agent (Plumbline $version)" "the agent"
expectEqual "$("$root/usr/bin/plumbline-agent" --version)" "plumbline-agent (Plumbline $version)" "the agent by its name in bin"
"$root/usr/bin/plumbline-game" --seed 3 --limit 1 --output "$scratch/run" > game.txt 2>&1 || [[ $? == 1 ]] || fail "game: $(cat game.txt)"
grep -q 'no goal within 1 s' game.txt || fail "an unpacked game says: $(cat game.txt)"
for page in "$root"/usr/share/man/man1/*.1; do
  grep -q '^\.TH PLUMBLINE-' "$page" && grep -q '^\.SH OPTIONS\|^\.SS "\?[Oo]ptions\|\\fB\\-\\-help' "$page" || fail "a page without options: ${page##*/}"
done
grep -q "^plumbline-agent \\\\- ." "$root/usr/share/man/man1/plumbline-agent.1" || fail "the agent's page: $(head -8 "$root/usr/share/man/man1/plumbline-agent.1")"
