# Where a kill or a signal comes, drawn by a seed; sourced by scripts/kills.sh and scripts/stops.sh.
takeSeed() { # SEED and what a run counts in; leaves `seed`
  seed=${SEED:-1}
  [[ $seed =~ ^[0-9]+$ && $1 =~ ^[0-9]+$ ]] || fail "${2} and SEED are whole numbers"
}

# Numbers below $1; the same row for the same seed, of each job another one.
below() {
  state=$(((state * 1103515245 + 12345) % 2147483648))
  drawn=$(((state >> 8) % $1))
}

# `state`, `callsBefore` and `fileKinds` of a job that was prepared; they are the caller's.
beginDraws() { # job
  local kind
  state=$seed
  for kind in $all moment; do
    callsBefore[$kind]=$(callsOf $kind)
    ((callsBefore[$kind] == 0)) || [[ $kind == malloc || $kind == moment ]] || fileKinds+=($kind)
  done
  for kind in $(printf '%s' "$1" | od -An -v -tu1); do state=$(((state * 31 + kind) % 2147483648)); done
}

# The next `place` among a job's calls: as often within file work as anywhere, and as often of each further kind.
drawPlace() { # further kinds
  local kind ways=(malloc file "$@")
  below ${#ways[@]}
  kind=${ways[drawn]}
  if [[ $kind == file ]]; then
    kind=malloc
    if ((${#fileKinds[@]})); then
      below ${#fileKinds[@]}
      kind=${fileKinds[drawn]}
    fi
  fi
  below $((callsBefore[$kind] > 0 ? callsBefore[$kind] : 1))
  place=$kind:$((drawn + 1))
}
