#!/usr/bin/env bash
# Puts the page of bin/gap report together in build/report/page.html: one file with its style, its scripts and uPlot
# inside. scripts/build_page.sh calls it once the packages from npm are there.
#   scripts/build_report_page.sh PACKAGES
# Example: scripts/build_report_page.sh build/web-packages
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
uplot=$1/node_modules/uplot
from=web/report new=build/report.new
scripts=(dom words verdict heatmap figure plot tracks causes overlays bars data main)

rm -rf "$new"
mkdir -p "$new"
{
  printf '/* uPlot, MIT licence:\n%s\n*/\n' "$(cat "$uplot/LICENSE")"
  cat "$uplot/dist/uPlot.iife.min.js"
  for script in "${scripts[@]}"; do cat "$from/js/$script.js"; done
} > "$new/script"
cat "$uplot/dist/uPlot.min.css" "$from/style.css" > "$new/style"
# A script inside a page must not hold what ends it.
if grep -qi '</script' "$new/script"; then echo "$0: a script holds </script" >&2; exit 2; fi
awk -v style="$new/style" -v script="$new/script" '
  function pour(file, mark,   at, line) {
    at = index($0, mark)
    printf "%s", substr($0, 1, at - 1)
    while ((getline line < file) > 0) print line
    print substr($0, at + length(mark))
  }
  index($0, "/*STYLE*/") { pour(style, "/*STYLE*/"); next }
  index($0, "/*SCRIPT*/") { pour(script, "/*SCRIPT*/"); next }
  { print }' "$from/page.html" > "$new/page.html"
rm "$new/script" "$new/style"
rm -rf build/report
mv "$new" build/report
