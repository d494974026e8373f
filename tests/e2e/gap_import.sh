# Logs as other programs write them become a run: commands and readings in two files with clocks of their own, lists in
# cells, units that nobody wrote down. The same motion in one table gives the same run.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
command -v python3 > /dev/null || fail "no python3: scripts/install_packages.sh scripts/packages-test.txt installs it"
arm=tests/e2e/gap/arm.json

# A motion of the arm, and its logs: 100 readings and 50 commands in a second; the controller's clock is 2 s behind, in ms.
gap record --robot $arm --program hang_sweep --seed 3 -o "$scratch/real"
python3 - "$scratch" << 'P'
import csv, gzip, math, sys
folder = sys.argv[1]
rows = list(csv.DictReader(gzip.open(folder + "/real/run.csv.gz", "rt")))
degrees = lambda text: repr(round(math.degrees(float(text)), 6))
joints = [name[4:] for name in rows[0] if name.startswith("cmd.")]
with open(folder + "/commands.csv", "w") as out:
    out.write("sent," + ",".join("goal_" + joint for joint in joints) + "\n")
    for row in rows[::2]:
        out.write(repr(round(1e3 * float(row["t"]) - 2000 - 1, 3)) + "," + ",".join(degrees(row["cmd." + j]) for j in joints) + "\n")
with open(folder + "/readings.csv", "w") as out:
    out.write("stamp,q\n")
    for row in rows:
        out.write(str(round(1e6 * float(row["t"]))) + ",\"[" + ", ".join(row["pos." + j] for j in joints) + "]\"\n")
P
cat > "$scratch/map.yaml" << 'Y'
robot: arm
base: fixed
motion: sweep
rename: {Elbow: 0, Shoulder: 1}
tables:
  - time: {from: sent, offset: 2}
    columns: [{to: "cmd.*", from: "goal_*"}]
  - time: {from: stamp}
    columns: [{to: "pos.*", from: "q[*]", unit: rad}]
Y
gap import --map "$scratch/map.yaml" --robot $arm "$scratch/commands.csv" "$scratch/readings.csv" -o "$scratch/run"
grep -q "commands.csv: sent is taken as ms" "$scratch/out" || fail "the unit of the time is not said: $(cat "$scratch/out")"
grep -q "cmd.\* are taken as deg: " "$scratch/out" || fail "the unit of the commands is not said: $(cat "$scratch/out")"
grep -q "sent 1 ms before their row" "$scratch/out" || fail "the distance of the clocks is not said: $(cat "$scratch/out")"
python3 - "$scratch" << 'P' || fail "the run differs from the motion"
import csv, gzip, json, sys
folder = sys.argv[1]
read = lambda path: list(csv.DictReader(gzip.open(path, "rt")))
real, run = read(folder + "/real/run.csv.gz"), read(folder + "/run/run.csv.gz")
assert len(run) == len(real), (len(run), len(real))
for i, (a, b) in enumerate(zip(real, run)):
    assert abs(float(a["t"]) - float(b["t"])) < 1e-6
    for name in b:
        if name.startswith("pos."): assert abs(float(a[name]) - float(b[name])) < 1e-5, (i, name)
        # Every second command was logged; it holds for two rows.
        if name.startswith("cmd."): assert abs(float(real[i - i % 2][name]) - float(b[name])) < 1e-5, (i, name)
timing = json.load(open(folder + "/run/run.json"))["timing"]["cmd_at_s"]
assert all(abs(value + 0.001) < 1e-6 for value in timing.values()), timing
P

# What was stated is not changed; what is not clear is asked for; clocks that have nothing in common are an error.
sed 's/"goal_\*"/"goal_*", unit: rad/' "$scratch/map.yaml" > "$scratch/stated.yaml"
gap import --map "$scratch/stated.yaml" --robot $arm "$scratch/commands.csv" "$scratch/readings.csv" -o "$scratch/stated"
if grep -q "cmd.* taken as" "$scratch/out"; then fail "a stated unit was guessed: $(cat "$scratch/out")"; fi
sed 's/, offset: 2//' "$scratch/map.yaml" > "$scratch/clocks.yaml"
awk -F, -v OFS=, 'NR > 1 { $1 -= 1e6 } 1' "$scratch/commands.csv" > "$scratch/early.csv"
status=0
"$bin/gap" import --map "$scratch/clocks.yaml" --robot $arm "$scratch/early.csv" "$scratch/readings.csv" -o "$scratch/x" 2> "$scratch/err" || status=$?
expectEqual $status 2 "the status for times that do not overlap"
grep -q "do not overlap those of .*readings.csv.*offset of [0-9.]* s both begin together" "$scratch/err" ||
  fail "clocks: $(cat "$scratch/err")"
printf 'stamp,q_Elbow\n0,-1.6\n0.01,1.6\n' > "$scratch/unclear.csv"
printf 'robot: arm\nbase: fixed\nmotion: m\ntime: {from: stamp, unit: s}\ncolumns: [{to: pos.Elbow, from: q_Elbow}]\n' > "$scratch/unclear.yaml"
status=0
"$bin/gap" import --map "$scratch/unclear.yaml" --robot $arm "$scratch/unclear.csv" -o "$scratch/x" 2> "$scratch/err" || status=$?
expectEqual $status 2 "the status for a unit that is not clear"
grep -q "^gap: $scratch/unclear.yaml:5: columns\[0\].from has no unit; pos.Elbow .*unit: rad or unit: deg$" "$scratch/err" ||
  fail "a unit that is not clear: $(cat "$scratch/err")"
[[ ! -e $scratch/x && ! -e $scratch/x.part ]] || fail "a refused import wrote something"
