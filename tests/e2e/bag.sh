# Programs that share no code with the project read a log: a reader in Python that knows rosbag2's tables and CDR, and
# Cyclone DDS with types made from the log's own definitions. Cyclone DDS writes each message again and gets the same
# bytes.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
for program in idlc python3 cc; do
  command -v $program > /dev/null || fail "no $program: scripts/install_packages.sh scripts/packages-test.txt installs it"
done
"$bin/game" --seed 8 --limit 4 --output "$scratch/out" --agent-option=--log --agent-option="$scratch/game" --agent-option=--log-wait > /dev/null || true
read=(python3 tests/e2e/bag/read.py "$scratch/game")
said=$("${read[@]}" --csv "$scratch/values.csv") || fail "the reader in Python"
[[ $said =~ ^([0-9]+)' messages of '([0-9]+)' topics'$ ]] || fail "it says: $said"
messages=${BASH_REMATCH[1]}
((messages > 3000 && BASH_REMATCH[2] > 40)) || fail "a game of four seconds has $said"

# The same values as bin/logtool, which is of the project, finds.
columns=FrameInfo.time,GameState.playMode,BallPos.relative,BallPos.valid,RobotPose,FKModel.com,SensorData.acc
"$bin/logtool" export "$scratch/game" --csv "$scratch/table.csv" --only $columns > /dev/null
python3 - "$scratch/values.csv" "$scratch/table.csv" << 'P' || fail "the reader in Python finds other values"
import csv, re, sys
snake = lambda name: re.sub(r"(?<=[a-z0-9])([A-Z])", r"_\1", name).lower()
values = {}
for topic, stamp, field, text in csv.reader(open(sys.argv[1])):
    values.setdefault(topic.split("/")[-1] + "." + field, []).append((int(stamp), float(text == "True" if text in ("True", "False") else text)))
compared = 0
table = csv.DictReader(open(sys.argv[2]))
at = {}
for row in table:
    now = round(float(row["time"]) * 1e9)
    for column, text in row.items():
        if column in ("time", "cycle") or not text: continue
        kind, path = column.split(".", 1)
        known = values[kind + "." + ".".join(map(snake, path.split(".")))]
        i = at.get(column, 0)
        while i + 1 < len(known) and known[i + 1][0] <= now: i += 1
        at[column] = i
        expected = {"true": 1.0, "false": 0.0}.get(text) if text in ("true", "false") else float(text)
        if abs(known[i][1] - expected) > 1e-6 * max(1, abs(expected)):
            sys.exit(f"{column} at {row['time']}: {known[i][1]}, not {text}")
        compared += 1
if compared < 2000: sys.exit(f"only {compared} values compared")
P

# Cyclone DDS.
"${read[@]}" --idl "$scratch/Bag.idl" > "$scratch/types.txt" || fail "no IDL"
(cd "$scratch" && idlc Bag.idl > idlc.log 2>&1) || fail "idlc refuses the definitions: $(head -3 "$scratch/idlc.log")"
{
  echo '#include "Bag.h"'
  echo 'static struct { const char* name; const dds_topic_descriptor_t* descriptor; const struct ddsi_sertype* type; } bagTypes[] = {'
  while read -r name root; do echo "{\"$name\", &bag_${root}_desc, NULL},"; done < "$scratch/types.txt"
  echo '};'
} > "$scratch/bag_types.h"
cc -std=gnu11 -w -I "$scratch" tests/e2e/bag/cyclone.c "$scratch/Bag.c" -o "$scratch/cyclone" -lddsc -lsqlite3 2> "$scratch/cc.log" ||
  fail "the reader with Cyclone DDS: $(head -3 "$scratch/cc.log")"
export CYCLONEDDS_URI='<General><Interfaces><NetworkInterface address="127.0.0.1" multicast="true"/></Interfaces></General>'
expectEqual "$("$scratch/cyclone" "$scratch"/game/*.db3 2> "$scratch/cyclone.log")" "$messages messages" "Cyclone DDS ($(tail -1 "$scratch/cyclone.log"))"

# Both would notice a message that was cut.
cp -r "$scratch/game" "$scratch/cut"
python3 -c 'import glob, sqlite3, sys
database = sqlite3.connect(glob.glob(sys.argv[1] + "/*.db3")[0])
database.execute("UPDATE messages SET data = substr(data, 1, length(data) - 8) WHERE id = 1000")
database.commit()' "$scratch/cut"
! python3 tests/e2e/bag/read.py "$scratch/cut" --csv "$scratch/none" 2> /dev/null || fail "a message that was cut is read in Python"
! "$scratch/cyclone" "$scratch"/cut/*.db3 > /dev/null 2>&1 || fail "a message that was cut is read by Cyclone DDS"
