#!/usr/bin/env bash
# Before the compiler of each source. A bundle, a source that includes others, may fail because names in them meet:
# then its halves are compiled, and so on, and their objects joined. So an error in a source is told as if there were
# no bundles, and no name has to be unlike another file's.
#   compile_bundle.sh COMPILER OPTION... -MD -MT X -MF DEPENDENCIES -o OBJECT -c SOURCE
set -euo pipefail
bundle=${*: -1}
[[ $bundle == */Unity/unity_*.cxx ]] || exec "$@"
if said=$("$@" 2>&1); then
  [[ ! $said ]] || printf '%s\n' "$said"
  exit 0
fi
command=("${@:1:$#-1}")
for ((i = 0; i < ${#command[@]}; ++i)); do
  case ${command[i]} in
    -o) at=$((i + 1)) object=${command[i + 1]} ;;
    -MF) dependenciesAt=$((i + 1)) dependencies=${command[i + 1]} ;;
  esac
done
parts=() # objects that succeeded, each with its dependencies beside it

compile() { # $1: what; prints what the compiler says
  local part=${object%.o}.${#parts[@]}.part.o
  command[at]=$part command[dependenciesAt]=${part%.o}.d
  "${command[@]}" "$1" 2>&1 || return 1
  parts+=("$part")
}

compileHalves() { # $1: the first of the sources, $2: how many, which do not go together
  local part=${bundle%.cxx}.part.cxx half=$(($2 / 2)) from count
  if (($2 == 1)); then compile "${sources[$1]}" >&2; return; fi
  for from in "$1" "$(($1 + half))"; do
    count=$((from == $1 ? half : $2 - half))
    printf '#include "%s"\n' "${sources[@]:from:count}" > "$part"
    compile "$part" > "$part.log" || compileHalves "$from" "$count" || return
  done
}

trap 'rm -f "${parts[@]}" "${parts[@]/%.o/.d}" "${bundle%.cxx}".part.*' EXIT
mapfile -t sources < <(sed -n 's/^#include "\(.*\)"$/\1/p' "$bundle")
compileHalves 0 ${#sources[@]} || exit
echo "${bundle##*/}: in halves, as: $(grep -m 1 error <<< "$said")" >&2
if ((${#parts[@]} == 1)); then mv -f "${parts[0]}" "$object"; else ld -r -o "$object" "${parts[@]}"; fi
# What was put together here is gone by the next build.
sed 's#\([^ \\]\|\\.\)*\.part\.cxx##' "${parts[@]/%.o/.d}" > "$dependencies"
