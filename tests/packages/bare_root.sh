#!/usr/bin/env bash
# Installs the packages of `make deb` on a bare Debian 12 and runs them there. Needs root, mmdebstrap, the mirrors of
# Debian and some GB of disk; no test of the gate.
#   bare_root.sh [FOLDER_OF_PACKAGES]          default: build/package
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."

packages="$(cd "${1:-build/package}" && pwd)"
root="$(mktemp -d)"
unmount() { for place in proc sys dev; do umount --recursive "$root/$place" 2>/dev/null || true; done; }
trap 'unmount; rm -rf --one-file-system "$root"' EXIT

echo "A bare Debian 12 in $root."
mmdebstrap --quiet --variant=apt bookworm "$root"
mkdir "$root/packages"
cp "$packages"/*.deb "$root/packages"
mount -t proc proc "$root/proc"
mount --rbind /sys "$root/sys" && mount --make-rslave "$root/sys"
mount --rbind /dev "$root/dev" && mount --make-rslave "$root/dev"
inside() { chroot "$root" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }

before="$(du -sm --one-file-system "$root" | cut -f1)"
inside apt-get update -qq
inside sh -c 'apt-get install -qq -y --no-install-recommends /packages/interlock_*.deb' >"$root/apt.log" 2>&1 ||
  { tail -20 "$root/apt.log"; exit 1; }
inside apt-get clean
echo "Installed: $(grep -c '^Setting up' "$root/apt.log") packages, $(($(du -sm --one-file-system "$root" | cut -f1) - before)) MB."

inside interlock --version
inside interlock --help | head -3
inside sh -c 'ldd /usr/bin/interlock | grep -F "not found"' && { echo "A library is missing."; exit 1; }
inside test -s /usr/share/man/man1/interlock.1
inside test -s /usr/share/bash-completion/completions/interlock
# Small runs, as somebody who is not root. Figures come with the recommended packages, which are not here.
inside useradd -m somebody
inside su - somebody -c 'interlock run /usr/share/interlock/cases/benchmark/w1.prm -o w1' | tail -8
inside su - somebody -c 'interlock run /usr/share/interlock/cases/geogrids/bx1100.prm -o sheet' 2>&1 | tail -4
echo "What the loader takes here:"
inside su - somebody -c 'LD_DEBUG=libs interlock --version 2>&1 | grep "calling init.*libinterlock" | sed "s/.*calling init: //"' || true
echo "Installed and used on a bare Debian 12."
