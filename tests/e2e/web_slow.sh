# The page in a browser that draws two pictures a second shows whole robots, as does the node test of what it draws
# between two messages, and other parts of it.
source "$(dirname "${BASH_SOURCE[0]}")/assert.bash"
for program in node chromium; do
  command -v $program > /dev/null || fail "no $program: scripts/install_packages.sh scripts/packages-test.txt installs it"
done
scripts/build_page.sh || fail "the page could not be built"
mkdir -p build/e2e
node --test tests/e2e/web/*.test.mjs || fail "parts of the page; see above"

"$bin/game" --web --stay --realtime --seed 1 --output "$scratch/run" > "$scratch/game.log" 2>&1 &
game=$!
waitFor grep -q 'watch at' "$scratch/game.log"
url=$(sed -n 's#.*\(http://localhost:[0-9]*/\).*#\1#p' "$scratch/game.log")
timeout 900 node tests/e2e/web/slow.mjs "$url" build/e2e/web-slow.png || fail "see above; $(tail -1 "$scratch/game.log")"
kill -INT $game
wait $game || true
