#!/usr/bin/env bash
# What a fresh machine needs for the first command: `make run` installs scripts/packages.txt and nothing else.
cd "$(dirname "$0")/../.."
status=0
mapfile -t needed < <(sed -n '/OPTIONAL/d; s/.*PACKAGE "\{0,1\}\([a-z0-9+. -]*\).*/\1/p' cmake/Externals.cmake |
  sed 's/ and / /g; s/ LIBRARIES.*//' | tr ' ' '\n' | sed '/^$/d' | LC_ALL=C sort -u)
((${#needed[@]} >= 10)) || { echo "only ${#needed[@]} packages found in cmake/Externals.cmake"; exit 1; }
for package in "${needed[@]}"; do
  grep -q "^$package  #" scripts/packages.txt ||
    { echo "cmake/Externals.cmake stops without $package, which scripts/packages.txt does not install"; status=1; }
done
exit $status
