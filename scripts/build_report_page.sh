#!/usr/bin/env bash
# Puts the pages of bin/gap report and bin/webmonitor --summary together, build/report/page.html and summary.html: each one
# file with its style and its scripts inside. scripts/build_page.sh calls it once the packages from npm are there.
#   scripts/build_report_page.sh PACKAGES
# Example: scripts/build_report_page.sh build/web-packages
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
uplot=$1/node_modules/uplot
new=build/report.new
rm -rf "$new"
mkdir -p "$new"

# Makes $new/$2 of the page in a folder of web/ ($1) from $new/script and $new/style.
pour() {
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
    { print }' "web/$1/page.html" > "$new/$2"
  rm "$new/script" "$new/style"
}

{
  printf '/* uPlot, MIT licence:\n%s\n*/\n' "$(cat "$uplot/LICENSE")"
  cat "$uplot/dist/uPlot.iife.min.js"
  for script in dom words verdict heatmap figure plot tracks causes overlays recordings bars data main; do cat "web/report/js/$script.js"; done
} > "$new/script"
cat "$uplot/dist/uPlot.min.css" web/report/style.css > "$new/style"
pour report page.html

for script in events decisions field score main; do cat "web/summary/js/$script.js"; done > "$new/script"
cp web/summary/style.css "$new/style"
pour summary summary.html

rm -rf build/report
mv "$new" build/report
