#!/usr/bin/env bash
# What a newcomer waits for: `make run` of the committed tree in an empty Debian 12 (debootstrap's smallest system, with make, git and
# certificates), from the first package to the goal. With TESTS=yes `make test` follows, some 20 minutes of two cores. Needs root, for
# chroot; MIRROR is where packages come from. Writes build/bench/fresh.json and fresh.md; `make bench-fresh` writes doc/results/fresh.md.
set -euo pipefail
root=$(cd "$(dirname "$0")/../../.." && pwd)
"$root/scripts/install_packages.sh" "$root/scripts/packages-bench.txt"
mkdir -p "$root/build/bench"
mirror=${MIRROR:-http://deb.debian.org/debian}
fail() { echo "fresh: $*" >&2; exit 2; }
((EUID == 0)) || { echo "fresh: left out, chroot needs root" >&2; exit 0; }
system=$(mktemp -d)
leave() {
  local at
  for at in proc sys dev/pts dev; do umount -l "$system/$at" 2> /dev/null || true; done
  # What is still mounted must not be deleted.
  grep -q " $system/" /proc/mounts || rm -rf --one-file-system "$system"
}
trap leave EXIT
trap 'exit 130' INT TERM
echo "fresh: makes an empty system from $mirror (a minute or two)"
debootstrap --variant=minbase --include=ca-certificates,make,git bookworm "$system" "$mirror" > "$root/build/bench/fresh.system" 2>&1 ||
  { tail -n 3 "$root/build/bench/fresh.system" >&2; fail "debootstrap failed; all of it is in build/bench/fresh.system"; }
for at in proc sys dev dev/pts; do mount --bind "/$at" "$system/$at"; done # dev/pts: tests have terminals
cp /etc/resolv.conf /etc/hosts "$system/etc/"
# Where a proxy signs for all sites, only this machine's certificates say that it may.
cp /etc/ssl/certs/ca-certificates.crt "$system/etc/ssl/certs/"
git clone -q "$root" "$system/root/plumbline"
echo "fresh: make run"
begin=$(date +%s.%N)
chroot "$system" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root bash -c 'cd /root/plumbline && make run' < /dev/null 2>&1 |
  while IFS= read -r line; do printf '%s\t%s\n' "$(date +%s.%N)" "$line"; done | tee "$root/build/bench/fresh.lines" | cut -f2-
tests=""
if [[ ${TESTS-} == yes ]]; then
  echo "fresh: make test (all it says is in build/bench/fresh.tests)"
  testBegin=$(date +%s.%N)
  chroot "$system" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root NODE_EXTRA_CA_CERTS=/etc/ssl/certs/ca-certificates.crt \
    bash -c 'cd /root/plumbline && make test' < /dev/null > "$root/build/bench/fresh.tests" 2>&1 ||
    { tail -n 20 "$root/build/bench/fresh.tests" >&2; fail "make test failed; all of it is in build/bench/fresh.tests"; }
  tests=$(awk -v b="$testBegin" -v e="$(date +%s.%N)" 'BEGIN { printf "%.0f", e - b }')
fi
awk -F'\t' -v begin="$begin" -v tests="$tests" -v json="$root/build/bench/fresh.json" -v load="$(cut -d ' ' -f 1 /proc/loadavg)" '
  function since(time) { return time - begin }
  { end = since($1) }
  !built && /\] (C\+\+|PCH|GEN)/ { packages = end; built = 1 }
  /\] / && /C\+\+|LINK|AR  / { compiled = end }
  /^[^\t]*\tgoal after/ { goal = end }
  END {
    if (!goal) { print "fresh: no goal; the output is in build/bench/fresh.lines" > "/dev/stderr"; exit 2 }
    print "From an empty Debian 12 to the goal; the machine had a load of " load " at the end.\n"
    print "| `make run` has | after [s] |\n|---|---|"
    printf "| installed its packages | %.0f |\n| compiled agent, simulator and game | %.0f |\n| scored | %.0f |\n", packages, compiled, goal
    if (tests != "") printf "\n`make test` in the same system, right after it, passed in %d s.\n", tests
    printf "[\n  {\"name\": \"fresh.packages\", \"value\": %.1f, \"unit\": \"s\", \"better\": \"lower\"},\n", packages > json
    printf "  {\"name\": \"fresh.make_run\", \"value\": %.1f, \"unit\": \"s\", \"better\": \"lower\", \"target\": 180}", goal > json
    if (tests != "") printf ",\n  {\"name\": \"fresh.make_test\", \"value\": %d, \"unit\": \"s\", \"better\": \"lower\", \"target\": 1200}", tests > json
    print "\n]" > json
  }' "$root/build/bench/fresh.lines" > "$root/build/bench/fresh.md"
cat "$root/build/bench/fresh.md"
