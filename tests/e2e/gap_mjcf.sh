# A model of MuJoCo in two files, with a gear, friction, damping and a ratio of damping, and a JSON file with the numbers at
# the joint are the same robot. A motion recorded of both is the same.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
command -v python3 > /dev/null || fail "no python3: scripts/install_packages.sh scripts/packages-test.txt installs it"
mkdir "$scratch/mjcf" "$scratch/mjcf/parts"
cat > "$scratch/mjcf/arm.xml" << 'X'
<mujoco model="one"><compiler angle="radian"/>
<include file="parts/body.xml"/>
<actuator><position joint="J" kp="0.05" dampratio="0.5" gear="10" forcerange="-0.3 0.3"/></actuator></mujoco>
X
cat > "$scratch/mjcf/parts/body.xml" << 'X'
<mujoco><worldbody><body name="base"><inertial pos="0 0 0" mass="1" diaginertia=".01 .01 .01"/>
<body name="arm"><inertial pos="0 0 -.2" mass=".5" diaginertia="1e-4 1e-4 1e-4"/>
<joint name="J" axis="0 1 0" range="-3 3" frictionloss="0.05" damping="0.02" armature=".004"/></body></body></worldbody></mujoco>
X
python3 - "$scratch" << 'P'
import json, math, sys
inertia = 0.5 * 0.2**2 + 1e-4 + 0.004
link = lambda mass, z, i: {"mass": mass, "com": [0, 0, z], "inertia": [i, i, i, 0, 0, 0]}
robot = {"name": "one", "links": {"base": link(1, 0, 0.01), "arm": link(0.5, -0.2, 1e-4)},
         "joints": [{"name": "J", "parent": "base", "child": "arm", "origin": [0, 0, 0], "axis": [0, 1, 0], "lower": -3, "upper": 3,
                     "max_torque": 3, "max_speed": 100, "friction": 0.05, "damping": 0.02,
                     "servo": {"kp": 5, "kd": 0.5 * 2 * math.sqrt(5 * inertia), "armature": 0.004}}]}
json.dump(robot, open(sys.argv[1] + "/one.json", "w"))
del robot["joints"][0]["friction"]
json.dump(robot, open(sys.argv[1] + "/smooth.json", "w"))
P
for robot in mjcf/arm.xml one.json smooth.json; do
  gap record --robot "$scratch/$robot" --program hang_sweep --seed 3 -o "$scratch/$(basename "$robot").run"
done
farthest() {
  python3 - "$scratch/arm.xml.run" "$scratch/$1.run" << 'P'
import csv, gzip, sys
a, b = (list(csv.DictReader(gzip.open(folder + "/run.csv.gz", "rt"))) for folder in sys.argv[1:])
assert len(a) == len(b) > 100
print(round(1e6 * max(abs(float(x["pos.J"]) - float(y["pos.J"])) for x, y in zip(a, b))))
P
}
(($(farthest one.json) < 20)) || fail "the model of MuJoCo moves by $(farthest one.json) urad differently from the JSON file"
(($(farthest smooth.json) > 1000)) || fail "friction moves it by no more than $(farthest smooth.json) urad"

# A motor takes torques alone: nothing can be recorded of it by positions.
sed 's/<position.*\/>/<motor joint="J" gear="3"\/>/' "$scratch/mjcf/arm.xml" > "$scratch/mjcf/motor.xml"
expectError 2 "gap: one: joint J takes torques alone, but positions are to be commanded; give it a position servo with kp and kd in the robot's file" \
  "$bin/gap" record --robot "$scratch/mjcf/motor.xml" --program hang_sweep -o "$scratch/x"
