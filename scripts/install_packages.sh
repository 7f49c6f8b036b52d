#!/usr/bin/env bash
# Installs those packages of packages.txt that this Debian machine does not have yet. Asks nothing, and
# touches neither the network nor apt when everything is there.
set -euo pipefail

list="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)/packages.txt"
mapfile -t wanted < <(sed -e 's/#.*//' -e 's/[[:space:]]//g' -e '/^$/d' "$list")

if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
  echo "This is not a Debian system (no apt-get): install the counterparts of the packages in" \
    "packages.txt with your own package manager, then run make with INSTALL=no." >&2
  exit 1
fi

installed="$(dpkg-query -W -f '${Package} ${db:Status-Status}\n' "${wanted[@]}" 2>/dev/null || true)"
missing=()
for package in "${wanted[@]}"; do
  grep -qx "$package installed" <<<"$installed" || missing+=("$package")
done
if [ ${#missing[@]} -eq 0 ]; then
  exit 0
fi

as_root=()
if [ "$(id -u)" -ne 0 ]; then
  if ! command -v sudo >/dev/null; then
    echo "These packages are missing, and installing them needs root or sudo; ask an administrator for:" \
      "apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 1
  fi
  as_root=(sudo)
fi

# Runs apt-get quietly; on failure shows what it said. Waits up to five minutes for a lock held by
# another installation.
apt_get()
{
  local log
  log="$(mktemp)"
  if ! "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -y -o DPkg::Lock::Timeout=300 \
    "$@" </dev/null >"$log" 2>&1; then
    tail -n 30 "$log" >&2
    echo "apt-get $1 failed; its last lines are above, all of them in $log." >&2
    exit 1
  fi
  rm -f "$log"
}

echo "Installing ${#missing[@]} missing Debian packages and what they depend on (some minutes the first" \
  "time): ${missing[*]}"
apt_get update
apt_get install --no-install-recommends "${missing[@]}"
