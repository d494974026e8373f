#!/usr/bin/env bash
# Puts the pages of bin/webmonitor and bin/agent together in build/web/, and that of bin/gap report in build/report/: their files
# from web/, three.js and uPlot from the npm registry that npm is set up for. With nothing changed it is done in a
# blink, without network.
#   scripts/build_page.sh [--if-easy]   --if-easy: leave it when that would need packages or network that are not there
# Examples:
#   scripts/build_page.sh             what `make web` does
#   scripts/build_page.sh --if-easy   what `make run` does
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
packages=build/web-packages page=build/web
easy=""
case ${1-} in
  --if-easy) easy=1 ;;
  ?*) echo "build_page.sh: no option $1; see build_page.sh --help" >&2; exit 2 ;;
esac

# One at a time: who asks beside another waits and finds all done, and no page goes while somebody reads it.
mkdir -p "$packages"
exec 9> "$packages/lock"
flock -w 900 9 || { echo "build_page.sh: another build of the page holds $packages/lock for 15 minutes; end it" >&2; exit 1; }
sources=$(find web scripts/build_page.sh scripts/build_report_page.sh -type f -print0 | LC_ALL=C sort -z | xargs -0 sha256sum | sha256sum)
made=("$page/index.html" build/report/page.html build/report/summary.html)
if ls "${made[@]}" > /dev/null 2>&1 && [[ $(cat "$packages/made" 2> /dev/null) == "$sources" ]]; then exit 0; fi

# Exactly the versions of the lock file, checked against their checksums there.
if ! cmp -s web/package-lock.json "$packages/installed"; then
  if ! command -v npm > /dev/null; then
    if [[ $easy ]]; then echo "The 3D page needs npm: \`make web\` installs it and builds the page"; exit 0; fi
    scripts/install_packages.sh scripts/packages-web.txt
  fi
  cp web/package.json web/package-lock.json "$packages/"
  patience=()
  if [[ $easy ]]; then patience=(--fetch-retries=0 --fetch-timeout=20000); fi
  if ! npm ci "${patience[@]}" --prefix "$packages" --omit=dev --ignore-scripts --no-audit --no-fund --loglevel=error > "$packages/log" 2>&1; then
    echo "build_page.sh: npm could not fetch three.js and uPlot: $(grep -m1 -i error "$packages/log" || echo "see $packages/log")" >&2
    if [[ $easy ]]; then exit 0; fi
    exit 2
  fi
  cp web/package-lock.json "$packages/installed"
fi

new=$page.new
rm -rf "$new"
mkdir -p "$new/three" "$new/uplot"
cp -r web/*.html web/*.css web/js "$new/"
uplot=$packages/node_modules/uplot
cp "$uplot/LICENSE" "$uplot/dist/uPlot.esm.js" "$uplot/dist/uPlot.min.css" "$new/uplot/"
three=$packages/node_modules/three
cp "$three/LICENSE" "$three/build/three.module.js" "$three/build/three.core.js" "$new/three/"
# The add-ons name three.js and each other as packages do; a page without inline scripts needs paths.
for addon in controls/OrbitControls geometries/RoundedBoxGeometry lines/LineSegments2 lines/LineSegmentsGeometry lines/LineMaterial; do
  sed "s#from 'three'#from './three.module.js'#; s#from '\.\./lines/#from './#" \
    "$three/examples/jsm/$addon.js" > "$new/three/${addon##*/}.js"
done
rm -rf "$page"
mv "$new" "$page"

scripts/build_report_page.sh "$packages"
echo "$sources" > "$packages/made"
