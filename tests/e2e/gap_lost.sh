# Lost commands, decoded by --method blocks and by sets: an answer, its bytes, what it remembers, and joints that were not logged.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
command -v node > /dev/null || fail "no node: scripts/install_packages.sh scripts/packages-test.txt installs it"
arm=tests/e2e/gap/arm.json
diagnose() { gap diagnose --method blocks --robot $arm "$@"; }
effectsIn() {
  node -e 'const a = JSON.parse(require("fs").readFileSync(process.argv[1])); console.log(a.verdict, a.effects.map((e) => e.effect + " " + e.at + " " + e.value.toFixed(e.at === "*" ? 1 : 2)).sort().join(", "))' "$1"
}

# They show only beside what else is found: repeats differ by more than noise until both are known.
cat > "$scratch/three.yaml" << 'E'
effects:
  - {effect: viscous_friction, at: Elbow, value: 0.3}
  - {effect: viscous_friction, at: Shoulder, value: 0.3}
  - {effect: command_dropout, at: "*", value: 0.08}
E
for seed in 2 3; do
  gap record --robot $arm --program hang_multisine --effects "$scratch/three.yaml" --seed $seed -o "$scratch/lost$seed"
done
diagnose "$scratch/lost2" "$scratch/lost3" --json "$scratch/lost.json"
expectEqual "$(effectsIn "$scratch/lost.json")" \
  "effect command_dropout * 0.1, viscous_friction Elbow 0.30, viscous_friction Shoulder 0.30" "the answer with lost commands"
[[ ! -e $scratch/lost.json.searches && ! -e $scratch/lost.json.searches2 ]] || fail "the diagnosis left its memory behind"

# A memory that cannot be written costs no answer. The same again, to the byte, and what it took in a file of its own.
mkdir "$scratch/memory" "$scratch/memory/a.json.searches"
diagnose "$scratch/lost2" --json "$scratch/memory/a.json"
grep -q '^gap: cannot write .*/a.json.searches: Is a directory; a diagnosis that is stopped from now on repeats what follows$' "$scratch/err" ||
  fail "a memory that cannot be written: $(cat "$scratch/err")"
diagnose "$scratch/lost2" --json "$scratch/again.json" --timing "$scratch/took.json" --jobs 1
cmp "$scratch/memory/a.json" "$scratch/again.json" || fail "the same recordings give another answer"
grep -q '^{"seconds": [0-9.]*, "cpu_seconds": [0-9.]*}$' "$scratch/took.json" || fail "timing: $(cat "$scratch/took.json")"

# A joint that was not logged, in the first 8 s: neither its commands nor its positions; another without commands alone.
for kept in 'Shoulder' 'Shoulder pos.Elbow'; do
  mkdir "$scratch/part"
  cp "$scratch/lost2/run.json" "$scratch/part"
  zcat "$scratch/lost2/run.csv.gz" | awk -F, -v kept="$kept" 'NR == 1 { n = split(kept, k, " ")
      for (i = 1; i <= NF; ++i) { use[i] = $i == "t"; for (j in k) if (index($i, k[j])) use[i] = 1 } }
    NR <= 801 { line = ""; for (i = 1; i <= NF; ++i) if (use[i]) line = line (line == "" ? "" : ",") $i; print line }' > "$scratch/part/run.csv"
  diagnose "$scratch/part" --json "$scratch/part.json"
  [[ $(effectsIn "$scratch/part.json") == *command_dropout* ]] ||
    fail "no lost commands in an arm of which $kept was logged: $(effectsIn "$scratch/part.json")"
  rm -r "$scratch/part"
done

# By sets, on a weak servo: there a loss takes a fifth of a second to show. A program that is named again is a repeat.
printf 'effects:\n  - {effect: command_dropout, at: "*", value: 0.08}\n' > "$scratch/weak.yaml"
gap record --robot xl330_pendulum --engine bullet --program hang_fast hang_multisine hang_fast \
  --effects "$scratch/weak.yaml" --seed 21 -o "$scratch/weak"
grep -q '"repeat_of": *"hang_fast"' "$scratch/weak/hang_fast_again/run.json" || fail "the third recording is no repeat of the first"
gap diagnose "$scratch/weak" --json "$scratch/weak.json"
expectEqual "$(effectsIn "$scratch/weak.json")" "effect command_dropout * 0.1" "the answer for a weak servo with lost commands"
