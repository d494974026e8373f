# What a test waits for comes long before, also on a busy machine: only what never comes takes so long, in seconds.
# tests/support/FarOff.h has the same for C++.
farOff=600
# Runs a program that may compute for so many seconds. The clock on the wall ends only what waits for ever: a busy machine
# is no failure.
within() { # seconds, command...
  (ulimit -S -t "$1"; exec timeout $((3 * farOff)) "${@:2}")
}
# Whether a command succeeds before long.
comesTrue() {
  local end=$((SECONDS + farOff))
  until "$@" > /dev/null 2>&1; do ((SECONDS < end)) || return 1; sleep 0.05; done
}
# How long a process and its threads have computed until now, in hundredths of a second.
computed() { awk '{ sub(/.*\) /, ""); print $12 + $13 }' "/proc/$1/stat" 2> /dev/null || echo 0; }
# Whether a process or a child of it is ready to run or waits for a disk, as on a busy machine.
wantsToGoOn() { # pid
  local pid
  for pid in "$1" $(pgrep -P "$1"); do grep -qs '^State:[[:space:]]*[RD]' /proc/"$pid"/task/*/status && return 0; done
  return 1
}
