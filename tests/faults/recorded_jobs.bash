# Jobs that read what was recorded: logs, matches, movements on the league's server. Sourced by jobs.bash.
situation=$tree/tests/data/situations/striker/freeInMidfield.yaml

job situations_take situations
situations_take_prepare() { cp -r "$sample" log; echo old > here.yaml; }
situations_take_run() { "$bin/situations" take log --time 1 --decides striker -o here.yaml; }
situations_take_outputs() { echo here.yaml; }

quickJob situations_draw situations
situations_draw_prepare() { cp "$situation" here.yaml; echo old > here.svg; }
situations_draw_run() { "$bin/situations" draw here.yaml; }
situations_draw_outputs() { echo here.svg; }

job situations_page situations
situations_page_prepare() { mkdir -p folder/striker && cp "$situation" folder/striker && echo old > page.md; }
situations_page_run() { "$bin/situations" page folder --pictures pictures -o page.md; }
situations_page_outputs() { echo page.md pictures/striker-freeInMidfield.svg; }

# A second of one player, with its decisions.
recordMatch() {
  "$bin/agent" --start-simulator --crash-log crash.log --decisions decisions --simulator-option=--sync --simulator-option=--seed \
    --simulator-option=3 --simulator-option=--kickoff-after=0.2 --simulator-option=--max-seconds=2 --simulator-option=--web=0 \
    --simulator-option=--record=match.plm > /dev/null
}

[[ ! -s $tree/build/report/summary.html ]] || job webmonitor_summary webmonitor # `make web` builds it
webmonitor_summary_prepare() { recordMatch; echo old > match.html; }
webmonitor_summary_run() { "$bin/webmonitor" --summary match.plm --decisions decisions -o match.html; }
webmonitor_summary_outputs() { echo match.html; }

# A visitor gets the page, then frames of the match until the program is interrupted. Where no memory is left for it, it is sent away.
job webmonitor_replay webmonitor
webmonitor_replay_prepare() { recordMatch; }
webmonitor_replay_run() { visitedAfterStart 0.1 "$bin/webmonitor" --replay match.plm --web-port 0; }

job simulator_replay simulator
simulator_replay_run() { "$bin/simulator" --replay "$tree/tests/data/traces/crouch_t1.csv.gz"; }
simulator_replay_prints() { :; }
