# A search by stages, each from what the one before found. Sourced with "$@" by scripts/optimise_kick.sh and scripts/optimise_sprint.sh
# after help.bash: takes their TYPE and the variables SEED, WORKERS, FOLDER and EFFORT, and goes on where it was stopped.
name=${0##*/}
fail() { echo "$name: $*; see $name --help" >&2; exit 2; }
root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
bin=${BIN:-$root/bin}
(($# == 1 || $# == 2)) || fail "needs a type"
type=$1 seed=${SEED:-1} workers=${WORKERS:-2} effort=${EFFORT:-1}
[[ $type =~ ^[0-9]$ && -d $root/config/robots/simspark_type$type ]] || fail "no robot type '$type'"
[[ $seed =~ ^[0-9]{1,9}$ ]] || fail "SEED is a whole number, not '$seed'"
[[ $effort =~ ^[0-9]+(\.[0-9]+)?$ ]] || fail "EFFORT is a number, not '$effort'"

# The configuration of stage $1: the project's, in which standard input is the type's file $2.
beginStage() {
  stage=$folder/stage$1
  [[ ! -f $stage/study.yaml ]] || return 0
  rm -rf "$stage/config"
  mkdir -p "$stage"
  cp -r "$root/config" "$stage/config"
  cat > "$stage/config/robots/simspark_type$type/$2"
}

# Its study: standard input has the task's part, the variables of the same names the search's.
writeStudy() {
  [[ ! -f $stage/study.yaml ]] || return 0
  {
    cat
    printf '%s\n' "optimizer: cmaes" "ahead: 1" "seed: $seed" "population: $population" "sigma: $sigma" "runs: $runs" "runsOfBest: $runsOfBest"
    awk -v g="$generations" -v e="$effort" 'BEGIN { g = int(g * e + 0.5); print "generations: " (g < 1 ? 1 : g) }'
  } > "$stage/study.new"
  mv "$stage/study.new" "$stage/study.yaml"
}

# bin/optserver for that study, with further options.
serveStage() { "$bin/optserver" "$stage/study.yaml" --config "$stage/config" --folder "$stage/search" "$@"; }
