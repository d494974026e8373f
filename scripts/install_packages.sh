#!/usr/bin/env bash
# Installs those packages of scripts/packages.txt that are missing; with all there it is done in a blink.
#   scripts/install_packages.sh [FILE]...   other lists than scripts/packages.txt
# Nothing that is installed is upgraded, and nothing that is only recommended comes along. PACKAGES=no: installs nothing
# and asks nothing, for systems that are no Debian (doc/dependencies.md lists the names there) and for those who want to
# choose themselves.
# Examples:
#   scripts/install_packages.sh
#   scripts/install_packages.sh scripts/packages-test.txt
#   make PACKAGES=no
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/help.bash"
cd "$(dirname "${BASH_SOURCE[0]}")/.."
export DEBIAN_FRONTEND=noninteractive

[[ ${PACKAGES-} == no ]] && exit 0
lists=("$@")
((${#lists[@]})) || lists=(scripts/packages.txt)
for list in "${lists[@]}"; do
  [[ -f $list ]] || { echo "install_packages.sh: no file $list" >&2; exit 2; }
done
# What the packages are called on other systems, from the table of doc/dependencies.md.
namesElsewhere() {
  sed -n '/^| Debian |/,/^$/ { /^|--/d; s/^| *//; s/ *|$//; s/`//g; s/ *| */;/g; p }' doc/dependencies.md |
    while IFS=';' read -r debian fedora arch brew; do printf '  %-22s %-24s %-20s %s\n' "$debian" "$fedora" "$arch" "$brew"; done
}

mapfile -t wanted < <(sed 's/#.*//; s/[[:space:]]//g; /^$/d' "${lists[@]}")

if ! command -v dpkg-query > /dev/null; then
  {
    echo "install_packages.sh: no dpkg here: this is no Debian. Install these by hand, then make again with PACKAGES=no:"
    namesElsewhere
  } >&2
  exit 2
fi
installed=" $(dpkg-query -W -f='${db:Status-Abbrev} ${binary:Package}\n' 2> /dev/null |
  sed -n 's/^ii  *//p' | sed 's/:.*//' | tr '\n' ' ')"
missing=()
for package in "${wanted[@]}"; do
  [[ $installed == *" $package "* ]] || missing+=("$package")
done
((${#missing[@]})) || exit 0

as=()
if ((EUID != 0)); then
  if ! command -v sudo > /dev/null; then
    echo "install_packages.sh: missing ${missing[*]}: neither root nor sudo; run as root: apt-get install ${missing[*]}" >&2
    exit 2
  fi
  as=(sudo)
  # Where nobody can type a password, say so instead of waiting.
  if [[ ! -t 0 ]] && ! sudo -n true 2> /dev/null; then
    echo "install_packages.sh: missing ${missing[*]}: sudo wants a password; run: sudo apt-get install ${missing[*]}" >&2
    exit 2
  fi
fi
apt=("${as[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3)

# The package lists are fetched only when they do not know what is missing, or when what they know is gone.
install() { "${apt[@]}" install -y -q --no-upgrade --no-install-recommends "${missing[@]}"; }
update() {
  echo "install_packages.sh: fetching the package lists"
  "${apt[@]}" update -q || { echo "install_packages.sh: apt-get update failed; see above" >&2; exit 2; }
}
echo "install_packages.sh: installing ${missing[*]}"
fresh=""
if ! apt-get install -s --no-install-recommends "${missing[@]}" > /dev/null 2>&1; then update; fresh=1; fi
if ! install; then
  if [[ ! $fresh ]]; then update; fi
  [[ ! $fresh ]] && install || {
    echo "install_packages.sh: apt-get could not install ${missing[*]}; its own words stand above" >&2
    exit 2
  }
fi
