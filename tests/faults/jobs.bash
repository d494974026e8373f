# What is tried with faults: job NAME PROGRAM, then in functions of the job's name what makes its folder
# (NAME_prepare), what runs (NAME_run) and what must hold whatever happened (NAME_check. The files of NAME_outputs are as
# they were, as they should be, or not there. With a ? their content differs from run to run). NAME_resumes names files that
# the same command comes to after a kill; what a job with NAME_prints prints is all it does. Of signals: NAME_ends are further
# statuses that one may end with, NAME_keeps patterns of what it may leave to go on from. `stopped` is set: agents and workers
# then end with status 0 before their work is done. Sourced after helpers.bash; $bin has the programs, $tree the tree.
all="write sync rename open malloc"
quick=() jobs=()
declare -A programOf
job() { jobs+=("$1"); programOf[$1]=$2; }
quickJob() { job "$@"; quick+=("$1"); }

arm=$tree/tests/e2e/gap/arm.json
gapProgram() { # seconds of motion, joint with an effect: what is to be recorded
  cat > program.yaml << END
about: "a short swing"
base: fixed
posture: hang
lead_in: 0.1
lead_out: 0.1
segments:
  - {wave: triangle, duration: $1, share: 0.45}
END
  printf 'effects:\n  - {effect: backlash, at: %s, value: 0.05}\n' "$2" > effects.yaml
}
gapRun() { # folder: a short recording of an arm with an effect
  gapProgram 1.6 Elbow
  "$bin/gap" record --robot "$arm" --program program.yaml --effects effects.yaml -o "$1" > /dev/null
}
gapAnswer() {
  cat > answer.json << 'END'
{"verdict": "effect", "robot": "arm", "effects": [{"effect": "backlash", "at": "Elbow", "value": 0.05, "unit": "rad",
 "interval": [0.04, 0.06], "probability": 0.9, "rivals": [{"effect": "coulomb_friction", "at": "Elbow", "value": 0.1, "probability": 0.1}]}],
 "gap": {"before": 2.5, "after": 1.1, "closed": 0.9}, "runs": [], "map": {"time": []}}
END
}

quickJob gap_record gap
gap_record_prepare() { gapProgram 1.6 Elbow; }
gap_record_run() { "$bin/gap" record --robot "$arm" --program program.yaml --effects effects.yaml -o run; }
gap_record_outputs() { echo run/run.json run/run.csv.gz; }

job gap_record_again gap
gap_record_again_prepare() { gapRun run; }
gap_record_again_run() { "$bin/gap" record --robot "$arm" --program program.yaml --seed 9 --force -o run; }
gap_record_again_outputs() { echo run/run.json run/run.csv.gz; }
gap_record_again_resumes() { gap_record_again_outputs; }

job gap_record_secret gap
gap_record_secret_prepare() { gapProgram 1.6 Elbow; }
gap_record_secret_run() { "$bin/gap" record --robot "$arm" --program program.yaml --secret 3 -o runs; }
gap_record_secret_outputs() { echo runs/run.json runs/run.csv.gz runs/SECRET; }

# A recording of one joint, short: a diagnosis of it takes a fifth of a second.
pendulumRun() {
  gapProgram 0.6 pendulum
  "$bin/gap" record --robot xl330_pendulum --program program.yaml --effects effects.yaml -o run > /dev/null
}

# Both methods have a memory of what they have searched, from which they go on.
job gap_diagnose gap
gap_diagnose_prepare() { pendulumRun; echo old > answer.json; }
gap_diagnose_run() { "$bin/gap" diagnose run --jobs 1 --max-causes 1 --quiet --json answer.json --timing took.json; }
gap_diagnose_outputs() { echo 'answer.json took.json?'; }
gap_diagnose_resumes() { echo answer.json; }
gap_diagnose_keeps() { echo "./answer.json.searches"; }

job gap_diagnose_blocks gap
gap_diagnose_blocks_prepare() { gap_diagnose_prepare; }
gap_diagnose_blocks_run() { "$bin/gap" diagnose run --jobs 1 --method blocks --max-causes 1 --quiet --json answer.json; }
gap_diagnose_blocks_outputs() { echo answer.json; }
gap_diagnose_blocks_resumes() { echo answer.json; }
gap_diagnose_blocks_keeps() { echo "./answer.json.searches"; }

quickJob gap_apply gap
gap_apply_prepare() { gapAnswer; echo old > effects.yaml; }
gap_apply_run() { "$bin/gap" apply answer.json -o effects.yaml; }
gap_apply_outputs() { echo effects.yaml; }

[[ ! -s $tree/build/report/page.html ]] || job gap_report gap # `make web` builds it
gap_report_prepare() { gapAnswer; echo old > report.html; }
gap_report_run() { "$bin/gap" report answer.json --robot "$arm" -o report.html; }
gap_report_outputs() { echo report.html; }

job gap_check gap
gap_check_prepare() { gapRun run; gapAnswer; echo old > check.json; }
gap_check_run() { "$bin/gap" check answer.json run --robot "$arm" --jobs 1 --json check.json; }
gap_check_outputs() { echo check.json; }

job gap_next gap
gap_next_prepare() { gapAnswer; sed -i 's/Elbow/pendulum/; s/"arm"/"xl330_pendulum"/' answer.json; echo old > next.yaml; }
gap_next_run() { "$bin/gap" next answer.json -o next.yaml; }
gap_next_outputs() { echo next.yaml; }

job gap_import gap
gap_import_prepare() {
  printf 'robot: xl330_pendulum\nbase: fixed\nmotion: "m"\ntime: {from: t, unit: s}\ncolumns:\n  - {to: cmd.pendulum, from: c}\n  - {to: pos.pendulum, from: p}\n' > map.yaml
  awk 'BEGIN { print "t,c,p"; for (i = 0; i < 300; ++i) printf "%.2f,%.4f,%.4f\n", i / 100, sin(i / 20), sin((i - 2) / 20) }' > raw.csv
}
gap_import_run() { "$bin/gap" import raw.csv --map map.yaml -o run; }
gap_import_outputs() { echo run/run.json run/run.csv.gz run/run.csv; }

job gap_settings gap
gap_settings_prepare() {
  mkdir traces
  cp "$tree"/tests/data/traces/crouch_t[013].csv.gz "$tree"/tests/data/traces/stand_t3.csv.gz traces
  echo old > answer.json
}
gap_settings_run() { "$bin/gap" settings --traces traces --jobs 1 --quiet --json answer.json; }
gap_settings_outputs() { echo answer.json; }

job gap_blind gap
gap_blind_run() { "$bin/gap" blind make --robot xl330_pendulum --engine replay --cases 1 --seed 4 --jobs 1 -o set; }
gap_blind_outputs() { echo set/answers.sealed; }

job gap_blind_score gap
gap_blind_score_prepare() {
  gap_blind_run > /dev/null
  mkdir answers
  gapAnswer
  for run in set/*/; do sed 's/Elbow/pendulum/; s/"arm"/"xl330_pendulum"/' answer.json > "answers/$(basename "$run").json"; done
}
gap_blind_score_run() { "$bin/gap" blind score set answers --list all; }
gap_blind_score_prints() { :; }

job gap_reveal gap
gap_reveal_prepare() { gapProgram 1.6 Elbow; gap_record_secret_run > /dev/null; }
gap_reveal_run() { "$bin/gap" reveal runs; }
gap_reveal_prints() { :; }

quickJob logtool_cut logtool
logtool_cut_prepare() { cp -r "$sample" log; }
logtool_cut_run() { "$bin/logtool" cut log part --from 0.2; }
logtool_cut_check() { readableLog part; }

job logtool_join logtool
logtool_join_prepare() { cp -r "$sample" log; "$bin/logtool" cut log a --to 0.5 > /dev/null; "$bin/logtool" cut log b --from 0.501 > /dev/null; }
logtool_join_run() { "$bin/logtool" join whole a b; }
logtool_join_check() { readableLog whole; }

quickJob logtool_csv logtool
logtool_csv_prepare() { cp -r "$sample" log; echo old > pose.csv; }
logtool_csv_run() { "$bin/logtool" export log --csv pose.csv --only RobotPose.position; }
logtool_csv_outputs() { echo pose.csv; }

job logtool_gap logtool
logtool_gap_prepare() { cp -r "$sample" log; }
logtool_gap_run() { "$bin/logtool" export log --gap run; }
logtool_gap_outputs() { echo run/run.json run/run.csv.gz; }

job agent_log agent
agent_log_prepare() { cp -r "$sample" log; }
agent_log_run() { "$bin/agent" --replay log --log again --crash-log crash.log; }
agent_log_check() { readableLog again; }

# Where the disk takes no more, the whole lines before stay.
job agent_decisions agent
agent_decisions_prepare() { "$bin/game" --seed 8 --limit 6 --output out --agent-option=--log --agent-option=log --agent-option=--log-wait > /dev/null || [[ -s log/metadata.yaml ]]; }
agent_decisions_run() { "$bin/agent" --replay log --decisions decisions --crash-log crash.log; }
agent_decisions_check() { # only a kill may leave half a line, which readers leave out
  local file=decisions/left-1.csv
  [[ -e $file ]] || return 0
  ! sed '$d' $file | awk -F, 'NF != 23' | grep . && { ((status == 137)) || { [[ ! $(tail -c 1 $file) ]] && ! awk -F, 'NF != 23' $file | grep .; }; }
}

job agent_graph agent
agent_graph_prepare() { echo old > graph.dot; }
agent_graph_run() { "$bin/agent" --graph graph.dot; }
agent_graph_outputs() { echo graph.dot; }

job agent_stats agent
agent_stats_prepare() { cp -r "$sample" log; echo old > stats.json; }
agent_stats_run() { "$bin/agent" --replay log --stats stats.json --crash-log crash.log; }
agent_stats_outputs() { echo 'stats.json?'; }

job simulator_record simulator
simulator_record_run() {
  "$bin/simulator" --port 0 --monitor-port 0 --web 0 --record match.plm --no-realtime --wait-agents 0 --max-seconds 10 --seed 3 \
    --ports-file ports.json --stats stats.json
}
simulator_record_outputs() { echo 'ports.json? stats.json?'; }
simulator_record_check() { readableMatch match.plm; }

job simulator_plain simulator
simulator_plain_run() {
  "$bin/simulator" --port 0 --monitor-port 0 --no-realtime --wait-agents 0 --max-seconds 2 --seed 3 --ports-file ports.json --stats stats.json
}
simulator_plain_outputs() { echo 'ports.json? stats.json?'; }

job game game
game_run() { "$bin/game" --seed 8 --limit 2 --output out; }
game_expects() { (($1 == 1)); } # no goal within two seconds
game_outputs() { echo "out/summary.json? out/track.svg${stopped:+?}"; } # stopped, it draws what was played

job optserver optserver
optserver_prepare() { printf 'task: function\noptions: {function: sphere, dimension: 2}\npopulation: 4\nruns: 1\nrunsOfBest: 1\ngenerations: 2\n' > study.yaml; }
optserver_run() { "$bin/optserver" study.yaml --folder search --workers 1 --port 0 --every 1000; }
optserver_check() { # every line of the journal but the last is whole
  [[ ! -s search/evaluations.jsonl ]] || ! sed '$d' search/evaluations.jsonl | grep -qv '}$'
}
optserver_resumes() { echo search/found.yaml; }

# From half of its results on, the last of which was cut off: none of the whole ones may be lost.
job optserver_again optserver
optserver_again_prepare() {
  optserver_prepare
  "$bin/optserver" study.yaml --folder search --workers 1 --port 0 > /dev/null
  head -5 search/evaluations.jsonl > before
  rm -r search
  mkdir search
  { cat before; printf '{"trial":4'; } > search/evaluations.jsonl
}
optserver_again_run() { optserver_run; }
optserver_again_check() { cmp before <(head -5 search/evaluations.jsonl) && optserver_check; }
optserver_again_resumes() { optserver_resumes; }

job optworker optworker
optworker_prepare() { optserver_prepare; }
optworker_run() { withOptserver "$bin/optworker" --patience 1 --port PORT; }
optworker_check() { # the server's results
  optserver_check && { ((status != 0)) || [[ ${stopped-} ]] || cmp <(comparable search/found.yaml) <(comparable ../good/search/found.yaml); }
}
optworker_resumes() { optserver_resumes; }

job optserver_measure optserver
optserver_measure_prepare() { optserver_prepare; "$bin/optserver" study.yaml --folder study.search --workers 1 --port 0 > /dev/null; }
optserver_measure_run() { "$bin/optserver" study.yaml --folder study.search --measure 5; }

job optimizewalk optimizewalk
optimizewalk_prepare() { echo '# old' > walking.yaml; }
optimizewalk_run() {
  "$bin/optimizewalk" --type 0 --task forward --generations 1 --population 4 --tries 1 --seconds 2 --jobs 1 --only step.duration \
    --from "$tree/config/robots/simspark_type0" --output walking.yaml
}
optimizewalk_outputs() { echo walking.yaml; }
optimizewalk_resumes() { echo walking.yaml; }
optimizewalk_keeps() { echo "./walking.yaml.search"; }

job watchgame watchgame
watchgame_prepare() { echo 'a line of an earlier game' > games.log; }
watchgame_run() {
  withSimulator "$bin/watchgame" --port PORT --players 0 --settle 0 --end-time 0.2 --hang 5 --limit 10 --quiet --log games.log --track track.txt
}
watchgame_expects() { (($1 <= 1)); }
watchgame_check() { [[ $(head -1 games.log) == 'a line of an earlier game' ]]; }

job webmonitor_record webmonitor
webmonitor_record_run() { withServer startSimulator stopAfterStart 0.1 "$bin/webmonitor" --port PORT --web-port 0 --drawing-port -1 --record match.plm; }
webmonitor_record_check() { readableMatch match.plm; }

job rdb rdb
rdb_prepare() { echo 'get r:BallPos' > script; }
rdb_run() { withServer startAgent "$bin/rdb" 127.0.0.1:PORT --script script; }

job agent_play agent
agent_play_run() {
  "$bin/agent" --start-simulator --simulator-option=--sync --simulator-option=--seed --simulator-option=3 \
    --simulator-option=--max-seconds --simulator-option=1 --stats stats.json --crash-log crash.log
}
agent_play_outputs() { echo 'stats.json?'; }

# Tries kicks by an optimiser of its own.
job agent_optimise agent
agent_optimise_prepare() {
  rm config
  cp -r "$tree/config" config
  printf 'host: ""\npopulation: 4\nruns: 1\ngenerations: 1\nfound: found.kick.yaml\n' > config/OptimizationClient.yaml
  echo 'rollSeconds: 1' > config/OptimizeMotion.yaml
}
agent_optimise_run() {
  "$bin/agent" --config config --crash-log crash.log --start-simulator --modules config/platforms/simspark/optimise.cfg \
    --simulator-option=--sync --simulator-option=--ground-truth
}
agent_optimise_outputs() { [[ ${stopped-} ]] || echo 'found.kick.yaml?'; }

# Without memory for the locale it draws in ASCII anyway.
job simplemonitor simplemonitor
simplemonitor_run() { withServer startSimulator "$bin/simplemonitor" --once --ascii --size 80x24 127.0.0.1:PORT; }
simplemonitor_prints() { :; }

job learnvalue learnvalue
learnvalue_prepare() {
  awk 'BEGIN {
    print "time,side,number,x,y,up,mode"
    for (i = 0; i < 200; ++i) {
      mode = i < 180 ? "PlayOn" : "Goal_Left"
      printf "%.1f,ball,0,%.2f,%.2f,1,%s\n", i / 2, i % 20 - 10, i % 7 - 3, mode
      printf "%.1f,left,1,%.2f,0,1,%s\n%.1f,right,1,%.2f,1,1,%s\n", i / 2, i % 20 - 11, mode, i / 2, i % 20 - 6, mode
    }
  }' > track.csv
  echo '# old' > value.yaml
}
learnvalue_run() { "$bin/learnvalue" track.csv -o value.yaml; }
learnvalue_outputs() { echo value.yaml; }
learnvalue_resumes() { echo value.yaml; }

source tests/faults/recorded_jobs.bash
source tests/faults/mpi_jobs.bash
