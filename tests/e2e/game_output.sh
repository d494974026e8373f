# bin/game from any folder writes into its project's build/run, and says in a line when it cannot write.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
bin=$(cd "$bin" && pwd)
mkdir "$scratch/elsewhere"
(cd "$scratch/elsewhere" && "$bin/game" --limit 1 > "$scratch/out" || true)
[[ -z $(ls -A "$scratch/elsewhere") ]] || fail "left in the folder it was called from: $(ls "$scratch/elsewhere")"
grep -q "see /.*/build/run$" "$scratch/out" || fail "does not say where it wrote: $(cat "$scratch/out")"

touch "$scratch/file"
expectError 2 "game: cannot write to $scratch/file/run: Not a directory; give --output another folder" "$bin/game" --output "$scratch/file/run"
# A device on which there is never room.
mkdir "$scratch/full"
if mount -t tmpfs -o size=16k none "$scratch/full" 2> /dev/null; then
  head -c 16k /dev/zero > "$scratch/full/rest" 2> /dev/null || true
  got=0
  text=$(within 20 "$bin/game" --output "$scratch/full/run" 2>&1 > /dev/null) || got=$?
  umount "$scratch/full"
  expectEqual "$got" 2 "status on a full disk"
  expectEqual "$text" "game: cannot write to $scratch/full/run: No space left on device; give --output another folder" "on a full disk"
fi

# After the goal the page stays on the last picture, until Ctrl-C.
scripts/build_page.sh || fail "the page could not be built"
"$bin/game" --web --stay --output "$scratch/stay" > "$scratch/stay.out" 2>&1 &
game=$!
waitFor grep -q '^goal after [0-9.]* s; the page stays on the last picture: press Ctrl-C to end$' "$scratch/stay.out"
python3 - "$(sed -n 's/^watch at //p' "$scratch/stay.out")" << 'END' || fail "the page is dead after the goal"
import sys, urllib.request
assert b"Plumbline" in urllib.request.urlopen(sys.argv[1], timeout=20).read()
END
kill -INT $game
status=0
wait $game || status=$?
expectEqual "$status" 0 "status after a goal and Ctrl-C"
tail -1 "$scratch/stay.out" | grep -q '^goal after' || fail "no last line: $(tail -1 "$scratch/stay.out")"
