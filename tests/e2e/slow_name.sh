# A name server that does not answer holds no program up: each ends by a signal at once, while it looks a host up.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"

# In place of libc's: it says which process asks, and nothing more.
cat > "$scratch/silent.c" << 'END'
#define _GNU_SOURCE
#include <dlfcn.h>
#include <netdb.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
int getaddrinfo(const char* host, const char* port, const struct addrinfo* hints, struct addrinfo** found) {
  int (*next)(const char*, const char*, const struct addrinfo*, struct addrinfo**) = dlsym(RTLD_NEXT, "getaddrinfo");
  if (!host || strcmp(host, "silent.example") != 0 || (hints && (hints->ai_flags & AI_NUMERICHOST))) return next(host, port, hints, found);
  FILE* asked = fopen(getenv("ASKED"), "a");
  fprintf(asked, "%d\n", (int)getpid());
  fclose(asked);
  sleep(3600);
  return EAI_AGAIN;
}
END
cc -O1 -shared -fPIC -o "$scratch/silent.so" "$scratch/silent.c" -ldl
export ASKED=$scratch/asked

endsWhileItAsks() { # signal, status, command...
  local signal=$1 wanted=$2 program=${3##*/} pid got=0
  shift 2
  rm -f "$ASKED"
  LD_PRELOAD=$scratch/silent.so "$@" < /dev/null > "$scratch/out" 2>&1 &
  pid=$!
  waitFor grep -qx $pid "$ASKED"
  endsBy "$signal" $pid "$program, which says '$(tail -1 "$scratch/out")',"
  wait $pid || got=$?
  expectEqual "$got" "$wanted" "status of $program after SIG$signal ($(tail -1 "$scratch/out"))"
}
endsWhileItAsks INT 0 "$bin/agent" --host silent.example --crash-log "$scratch/crash"
endsWhileItAsks TERM 130 "$bin/game" --host silent.example --output "$scratch/game"
endsWhileItAsks INT 130 "$bin/watchgame" --host silent.example
endsWhileItAsks TERM 0 "$bin/optworker" --host silent.example
endsWhileItAsks INT 130 "$bin/rdb" silent.example --exec help
endsWhileItAsks TERM 130 "$bin/simplemonitor" silent.example --once
endsWhileItAsks INT 130 "$bin/gap" record --robot simspark --host silent.example --program stand_squat -o "$scratch/run"
endsWhileItAsks INT 0 "$bin/webmonitor" --host silent.example --web-port 0 --drawing-port -1
expectEqual "$(ls "$scratch")" "$(printf '%s\n' asked game out silent.c silent.so | xargs -n1 | sort)" "what is left"

# What is listened on is a number, which no name server is asked about.
expectError 2 "simulator: cannot listen on silent.example: it is no address, as 127.0.0.1 or ::1" \
  env LD_PRELOAD="$scratch/silent.so" "$bin/simulator" --bind silent.example --token T --port 0 --monitor-port 0
