#!/usr/bin/env bash
# bin/optimizewalk: any number of jobs finds the same, and a search that was killed goes on to the same bytes.
source "$(dirname "${BASH_SOURCE[0]}")/../e2e/assert.bash"
search=("$bin/optimizewalk" --type 1 --task forward turn --generations 12 --population 4 --tries 1 --seconds 2)

"${search[@]}" --jobs 1 --output "$scratch/one.yaml" > "$scratch/one.log"
"${search[@]}" --jobs 3 --output "$scratch/three.yaml" > "$scratch/three.log"
cmp "$scratch/one.yaml" "$scratch/three.yaml" || fail "three jobs find another walk than one"
cmp "$scratch/one.log" "$scratch/three.log" || fail "three jobs say something else than one"
cmp -s <(tail -n +2 "$scratch/one.yaml") <(tail -n +2 config/robots/simspark_type1/walking.yaml) && fail "the search keeps the walk that it began with: what follows compares nothing"
[[ ! -e $scratch/one.yaml.search ]] || fail "a search that is done leaves its checkpoint"

# Killed and stopped again and again.
kills=0
for ((i = 0; i < 40; ++i)); do
  status=0
  if ((i < 30)); then
    timeout -s "$( ((i % 2)) && echo KILL || echo INT)" "0.$((3 + i % 7))" "${search[@]}" --output "$scratch/killed.yaml" > "$scratch/log" 2>&1 || status=$?
  else
    "${search[@]}" --output "$scratch/killed.yaml" > "$scratch/log" 2>&1 || status=$?
  fi
  ((status == 0)) && break
  kills=$((kills + 1))
done
((kills > 0)) || fail "the search was never killed"
cmp "$scratch/one.yaml" "$scratch/killed.yaml" || fail "a search that was killed $kills times finds another walk"

# A checkpoint of other options is refused; the walk is left as it is.
"${search[@]}" --output "$scratch/other.yaml" > /dev/null 2>&1 &
pid=$!
waitFor test -s "$scratch/other.yaml.search"
kill -KILL $pid
wait $pid 2> /dev/null || true
expectError 2 "optimizewalk: $scratch/other.yaml.search is of a search with other options, another walk to begin with or another program; remove it to begin anew" \
  "${search[@]}" --seed 2 --output "$scratch/other.yaml"

# Another optimiser by its name; it goes on after a stop as well, from the costs that it got.
swarm=("${search[@]}" --optimizer pso)
"${swarm[@]}" --output "$scratch/swarm.yaml" > /dev/null
cmp -s "$scratch/one.yaml" "$scratch/swarm.yaml" && fail "pso finds the walk of cmaes"
"${swarm[@]}" --output "$scratch/again.yaml" > /dev/null 2>&1 &
pid=$!
waitFor test -s "$scratch/again.yaml.search"
kill -KILL $pid
wait $pid 2> /dev/null || true
"${swarm[@]}" --output "$scratch/again.yaml" > /dev/null
cmp "$scratch/swarm.yaml" "$scratch/again.yaml" || fail "a swarm that was killed finds another walk"
expectError 2 'optimizewalk: --optimizer: unknown optimiser "cmeas"; did you mean "cmaes"?; see optimizewalk --help' \
  "$bin/optimizewalk" --optimizer cmeas
echo "killed $kills times"

# Names of parameters: an unknown one is an error with the nearest, before anything is tried or written.
expectError 2 'optimizewalk: no walking parameter "step.hight"; did you mean "step.height"?' \
  "${search[@]}" --only step.hight --output "$scratch/only.yaml"
mkdir "$scratch/from"
printf 'step:\n  hight: 0.03\n' > "$scratch/from/walking.yaml"
expectError 2 "optimizewalk: $scratch/from/walking.yaml:2: unknown key \"step.hight\"; did you mean \"height\"?" \
  "${search[@]}" --from "$scratch/from" --output "$scratch/only.yaml"
[[ ! -e $scratch/only.yaml && ! -e $scratch/only.yaml.search ]] || fail "a search that never began leaves a file"
