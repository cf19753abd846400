#!/bin/sh
# Runs the launcher in another Debian suite: makes a folder by debootstrap, mounts this source
# read-only in it and calls `run COMMAND` there (default: test), against that suite's Blender,
# Embree, OpenImageIO and Python. Folders live in build/compat or EYE_COMPAT_DIR, 3 GB each.
set -eu

root=$(CDPATH='' cd -- "$(dirname -- "$0")/.." && pwd)
suite=${1:-}
case $suite in
    trixie | sid) shift ;;
    *) echo "usage: run compat trixie|sid [COMMAND]" >&2; exit 1 ;;
esac
folder=${EYE_COMPAT_DIR:-$root/build/compat}/$suite

if [ "$(id -u)" -ne 0 ]; then
    exec sudo EYE_COMPAT_DIR="${EYE_COMPAT_DIR:-$root/build/compat}" "$0" "$suite" "$@"
fi
# All mounts are made in a namespace of this process: however it ends, they are gone.
if [ "${EYE_COMPAT_MOUNTS:-}" != private ]; then
    exec env EYE_COMPAT_MOUNTS=private unshare --mount --propagation private "$0" "$suite" "$@"
fi

make_folder() {
    command -v debootstrap >/dev/null || apt-get install -q -y debootstrap
    # The mirror that this machine's own packages come from.
    # shellcheck disable=SC2016  # apt expands it
    mirror=$(apt-get indextargets --format '$(REPO_URI)' 'Created-By: Packages' 'Label: Debian' |
        head -n 1)
    [ -n "$mirror" ] || { echo "run: apt knows no Debian mirror; try apt-get update" >&2; exit 1; }
    echo "Making $folder by debootstrap"
    rm -rf --one-file-system "$folder"
    mkdir -p "$folder"
    debootstrap --variant=minbase "$suite" "$folder" "$mirror" >"$folder.log" 2>&1 ||
        { tail -n 15 "$folder.log" >&2; exit 1; }
    apt-config dump | grep -E '^Acquire::(http|https)::Proxy|^Acquire::Check-' \
        >"$folder/etc/apt/apt.conf.d/80host" || true
    mkdir -p "$folder/eye_render"
    touch "$folder/.complete"
}

[ -e "$folder/.complete" ] || make_folder
mount -t proc proc "$folder/proc"
mount --rbind /dev "$folder/dev"
mount --bind "$root" "$folder/eye_render"
mount -o remount,bind,ro "$folder/eye_render"
cp /etc/resolv.conf "$folder/etc/resolv.conf"
# pip there trusts whom this machine trusts.
certificates=/etc/ssl/certs/ca-certificates.crt
if [ -e "$certificates" ]; then
    mkdir -p "$folder/etc/ssl/certs"
    cp "$certificates" "$folder$certificates"
fi
exec chroot "$folder" /usr/bin/env -i HOME=/root TERM="${TERM:-dumb}" LC_ALL=C.UTF-8 \
    PATH=/usr/sbin:/usr/bin:/sbin:/bin \
    PIP_CERT="$certificates" \
    EYE_BUILD_DIR=/var/tmp/eye_render/build EYE_OUT_DIR=/var/tmp/eye_render/out \
    /eye_render/run "${@:-test}"
