# A recording in the forms that other programs write gives the same run: a bag of ROS 2, a JSON list, a table with decimal
# commas and comments. A bag in MCAP is an error that says how to convert it.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
command -v python3 > /dev/null || fail "no python3: scripts/install_packages.sh scripts/packages-test.txt installs it"
arm=tests/e2e/gap/arm.json
gap record --robot $arm --program hang_sweep --seed 3 -o "$scratch/real"
python3 - "$scratch" << 'P'
import csv, gzip, json, os, sqlite3, struct, sys
folder = sys.argv[1]
rows = list(csv.DictReader(gzip.open(folder + "/real/run.csv.gz", "rt")))
joints = sorted(name[4:] for name in rows[0] if name.startswith("cmd."))

class Cdr:  # little endian; numbers are aligned to their size behind the four bytes of the header
    def __init__(self): self.bytes = b"\0\1\0\0"
    def put(self, form, size, value):
        self.bytes += b"\0" * (-(len(self.bytes) - 4) % size) + struct.pack("<" + form, value)
    def text(self, value):
        self.put("I", 4, len(value) + 1)
        self.bytes += value.encode() + b"\0"
    def header(self, t):
        nanoseconds = round(t * 1e9)
        self.put("i", 4, nanoseconds // 10**9)
        self.put("I", 4, nanoseconds % 10**9)
        self.text("")
    def texts(self, values):
        self.put("I", 4, len(values))
        for value in values: self.text(value)
    def doubles(self, values):
        self.put("I", 4, len(values))
        for value in values: self.put("d", 8, value)

def state(row, t):
    cdr = Cdr()
    cdr.header(t)
    cdr.texts(joints)
    cdr.doubles([float(row["pos." + joint]) for joint in joints])
    cdr.doubles([]), cdr.doubles([])
    return cdr.bytes

def goal(row, t):
    cdr = Cdr()
    cdr.header(t)
    cdr.texts(joints)
    cdr.put("I", 4, 1)
    cdr.doubles([float(row["cmd." + joint]) for joint in joints])
    cdr.doubles([]), cdr.doubles([]), cdr.doubles([])
    cdr.put("i", 4, 0), cdr.put("I", 4, 0)
    return cdr.bytes

os.mkdir(folder + "/bag")
bag = sqlite3.connect(folder + "/bag/bag_0.db3")
bag.execute("CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format TEXT, offered_qos_profiles TEXT)")
bag.execute("CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data BLOB)")
bag.execute("INSERT INTO topics VALUES(1, '/joint_states', 'sensor_msgs/msg/JointState', 'cdr', '')")
bag.execute("INSERT INTO topics VALUES(2, '/arm/goal', 'trajectory_msgs/msg/JointTrajectory', 'cdr', '')")
for row in rows:
    t = 1000 + float(row["t"])
    for topic, late, message in ((2, -1000, goal), (1, 0, state)):
        bag.execute("INSERT INTO messages(topic_id, timestamp, data) VALUES(?, ?, ?)", (topic, round(t * 1e9) + late, message(row, t)))
bag.commit()
open(folder + "/bag/metadata.yaml", "w").write("rosbag2_bagfile_information: {storage_identifier: sqlite3}\n")

json.dump([{"t": float(row["t"]), "goal": [float(row["cmd." + j]) for j in joints], "state": {"name": joints, "q": [float(row["pos." + j]) for j in joints]}}
           for row in rows], open(folder + "/list.json", "w"))
with open(folder + "/commas.csv", "w") as out:
    out.write("# logger 2.1\nt;" + ";".join("goal_" + j for j in joints) + ";" + ";".join("q_" + j for j in joints) + "\n")
    for i, row in enumerate(rows):
        if i == 10: out.write("# still running\n")
        out.write(";".join(row[name].replace(".", ",") for name in ["t"] + ["cmd." + j for j in joints] + ["pos." + j for j in joints]) + "\n")
P
head='robot: arm\nbase: fixed\nmotion: sweep\n'
printf "$head"'time: {from: joint_states.stamp}\ncolumns: [{to: "cmd.*", from: "arm.goal.positions.*"}, {to: "pos.*", from: "joint_states.position.*"}]\n' > "$scratch/bag.yaml"
printf "$head"'time: {from: t, unit: s}\nrename: {Elbow: 0, Shoulder: 1}\ncolumns: [{to: "cmd.*", from: "goal[*]", unit: rad}, {to: pos.Elbow, from: state.q.Elbow, unit: rad}, {to: pos.Shoulder, from: state.q.Shoulder, unit: rad}]\n' > "$scratch/list.yaml"
printf "$head"'separator: ";"\ntime: {from: t, unit: s}\ncolumns: [{to: "cmd.*", from: "goal_*", unit: rad}, {to: "pos.*", from: "q_*", unit: rad}]\n' > "$scratch/commas.yaml"
for form in bag list commas; do
  recording=$scratch/bag
  if [[ $form == list ]]; then recording=$scratch/list.json; fi
  if [[ $form == commas ]]; then recording=$scratch/commas.csv; fi
  gap import --map "$scratch/$form.yaml" --robot $arm "$recording" -o "$scratch/$form.run"
  cp "$scratch/out" "$scratch/$form.out"
  python3 - "$scratch/real" "$scratch/$form.run" << 'P' || fail "the run of the form $form differs from the motion"
import csv, gzip, sys
real, run = (list(csv.DictReader(gzip.open(folder + "/run.csv.gz", "rt"))) for folder in sys.argv[1:])
assert len(real) == len(run), (len(real), len(run))
names = [name for name in real[0] if name.split(".")[0] in ("cmd", "pos")]
assert len(names) == 4, names
for a, b in zip(real, run):
    for name in ["t"] + names: assert abs(float(a[name]) - float(b[name])) < 1e-5, (a["t"], name, a[name], b[name])
P
done
grep -q "commas.csv: numbers are read with decimal commas$" "$scratch/commas.out" || fail "decimal commas: $(cat "$scratch/commas.out")"
grep -q "commas.csv: lines that begin with # are left out: 2$" "$scratch/commas.out" || fail "comments: $(cat "$scratch/commas.out")"

touch "$scratch/x.mcap"
expectError 2 "gap: $scratch/x.mcap: is a bag in MCAP, which is not read; of a bag of another storage (.mcap) make one: echo 'output_bags: [{uri: converted, storage_id: sqlite3, all: true}]' > convert.yaml; ros2 bag convert -i $scratch/x.mcap -o convert.yaml; then import the folder converted" \
  "$bin/gap" import --map "$scratch/bag.yaml" "$scratch/x.mcap" -o "$scratch/x"
