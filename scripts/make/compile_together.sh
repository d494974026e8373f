#!/usr/bin/env bash
# Compiles a bundle, a source that includes others, in one go; where that fails because their names meet, its halves,
# and so on. So an error in a source is told as if there were no bundles.
#   compile_together.sh OBJECT DEPENDENCIES BUNDLE COMPILER [OPTION]...
set -euo pipefail
object=$1 dependencies=$2 bundle=$3
shift 3
# What is without a name in a source is without one in its bundle, whose main file it is not.
compiler=("$@" -Wno-subobject-linkage)
notes=() # names that met
parts=() # objects that succeeded, each with its dependencies beside it

compile() { # $1: what; prints what the compiler says
  local part=${object%.o}.${#parts[@]}.part.o
  "${compiler[@]}" -iquote . -MMD -MP -MT "$object" -MF "${part%.o}.d" -c "$1" -o "$part" 2>&1 || return 1
  parts+=("$part")
}

compileHalves() { # $@: sources
  local part=${bundle%.cpp}.part.cpp half
  if (($# == 1)); then compile "$1" >&2; return; fi
  printf '#include "%s"\n' "$@" > "$part"
  if compile "$part" > "$part.log"; then return; fi
  notes+=("$bundle: in halves, as: $(grep -m 1 error "$part.log" || head -1 "$part.log")")
  half=$(($# / 2))
  compileHalves "${@:1:half}" && compileHalves "${@:half+1}"
}

clean() { rm -f "${parts[@]}" "${parts[@]/%.o/.d}" "${bundle%.cpp}".part.*; }
trap clean EXIT
mapfile -t sources < <(sed -n 's/^#include "\(.*\)"$/\1/p' "$bundle")
compileHalves "${sources[@]}"
if ((${#parts[@]} == 1)); then mv -f "${parts[0]}" "$object"; else ld -r -o "$object" "${parts[@]}"; fi
# The sources themselves may go, as headers may: then a bundle is made anew.
{ sed "s# ${bundle%.cpp}.part.cpp# $bundle#" "${parts[@]/%.o/.d}"; printf '%s:\n' "${sources[@]}"; } > "$dependencies"
((${#notes[@]} == 0)) || printf '%s\n' "${notes[@]}" >&2
