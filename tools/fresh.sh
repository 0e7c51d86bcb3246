#!/usr/bin/env bash
# Runs a command in a clean clone of HEAD on a bare Debian 12, as a new user would, and reports minutes and megabytes.
#
#   tools/fresh.sh COMMAND...       for example: tools/fresh.sh ./dev test
#
# The bare root is made once by debootstrap, from the package sources of this computer, and kept as build/fresh/bare.tar. Each call unpacks
# it again; files that the command leaves in the root are removed afterwards. Needs root, and no network except for the package sources (and
# npm's registry, for commands that use npm).
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

say() { printf '%s\n' "$*" >&2; }
die() { say "fresh: $*"; exit 1; }
(($#)) || die "which command? For example: ./dev fresh ./dev test"
((EUID == 0)) || die "a bare root can only be made and entered by root"

suite=bookworm
store=$PWD/build/fresh
archive=$store/bare.tar
mkdir -p "$store"

# debian_sources: the Debian entries of this computer's package sources for the suite, one line each.
debian_sources() {
  local uri release component
  apt-get indextargets --format '$(ORIGIN)|$(REPO_URI)|$(RELEASE)|$(COMPONENT)' 'Created-By: Packages' |
    while IFS='|' read -r origin uri release component; do
      [[ $origin == Debian && $release == $suite* ]] || continue
      printf 'deb %s %s %s\n' "$uri" "$release" "$component"
    done | sort -u
}

# make_archive: a minimal base of debootstrap, with this computer's package sources.
make_archive() {
  local sources mirror work
  sources=$(debian_sources)
  mirror=$(awk -v suite=$suite '$3 == suite { print $2; exit }' <<<"$sources")
  [[ -n $mirror ]] || die "no package source of Debian 12 is known here; apt-get update first"
  work=$(mktemp -d "$store/bare.XXXXXX")
  say "Making a bare Debian 12 (once, about two minutes) ..."
  debootstrap --variant=minbase $suite "$work" "$mirror" >"$store/debootstrap.log" 2>&1 ||
    { tail -n 20 "$store/debootstrap.log" >&2; rm -rf "$work"; die "debootstrap failed (log: $store/debootstrap.log)"; }
  printf '%s\n' "$sources" >"$work/etc/apt/sources.list"
  rm -rf "$work"/var/cache/apt/archives/*.deb
  tar -C "$work" -cf "$archive.new" .
  mv "$archive.new" "$archive"
  rm -rf "$work"
}

# lend FILE...: copies files of this computer that its network needs (names, proxy, certificates).
lend() {
  local file
  for file; do
    [[ -f $file ]] || continue
    mkdir -p "$root$(dirname "$file")"
    cp -L "$file" "$root$file"
  done
}

# installed_kib ROOT: the sum of the sizes that its packages declare.
installed_kib() { awk '/^Installed-Size:/ { sum += $2 } END { print sum + 0 }' "$1/var/lib/dpkg/status"; }

[[ -f $archive ]] || make_archive
root=$(mktemp -d "$store/root.XXXXXX")
trap 'rm -rf --one-file-system "$root"' EXIT
tar -C "$root" -xf "$archive"
before=$(installed_kib "$root")

proxies=()
for name in http_proxy https_proxy no_proxy HTTP_PROXY HTTPS_PROXY NO_PROXY; do
  [[ -z ${!name:-} ]] || proxies+=("$name=${!name}")
done
lend /etc/resolv.conf /etc/hosts
cat /etc/apt/apt.conf.d/*proxy* >"$root/etc/apt/apt.conf.d/90proxy" 2>/dev/null || rm -f "$root/etc/apt/apt.conf.d/90proxy"
# The certificates are beside those that the package ca-certificates would write; it is not installed yet.
certificates=/etc/ssl/certs/ca-certificates.crt
if [[ -f $certificates ]]; then
  mkdir -p "$root/etc/ssl/lent"
  cp -L $certificates "$root/etc/ssl/lent/ca.crt"
  proxies+=(NODE_EXTRA_CA_CERTS=/etc/ssl/lent/ca.crt)
fi
git clone --quiet --no-hardlinks . "$root/root/armlet"

say "In a bare Debian 12, at $(git log -1 --format=%h): $*"
started=$SECONDS
status=0
# A namespace of its own: at the end, also after Ctrl-C, nothing stays mounted and no process keeps running.
unshare --mount --pid --fork --kill-child bash -c '
  root=$1; shift
  mount -t proc proc "$root/proc"
  mount --rbind /dev "$root/dev"
  mount -t tmpfs tmpfs "$root/tmp"
  exec chroot "$root" /usr/bin/env -i "$@"' fresh "$root" HOME=/root TERM="${TERM:-dumb}" \
  PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin ${proxies[@]+"${proxies[@]}"} \
  bash -c 'cd /root/armlet && exec "$@"' fresh "$@" || status=$?
seconds=$((SECONDS - started))
say "$(printf 'fresh: exit status %d after %d min %02d s; %d MB of packages installed for it, %d MB in the checkout' \
  "$status" $((seconds / 60)) $((seconds % 60)) $((($(installed_kib "$root") - before) / 1024)) \
  "$(du -sm "$root/root/armlet" | cut -f1)")"
exit "$status"
