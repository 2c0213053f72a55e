#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes a Debian package in build/package. Builds of one commit give the same bytes, in whatever folder they are made.
#
#   scripts/package.sh            installs what is missing, builds, and makes the package
#   scripts/package.sh --check    and checks it: lintian, desktop files, the bytes of a second build in another folder,
#                                 and the program in a bare Debian 12 (as root; takes a second build and a download)
set -uo pipefail
# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

case ${1:-} in
  '' | --check) ;;
  *) fail "unknown option '$1'; there is --check" ;;
esac

"$root/scripts/install_packages.sh" package || exit 1
umask 022
# The date of everything in the package.
SOURCE_DATE_EPOCH=$(git log -1 --format=%ct 2>/dev/null) || SOURCE_DATE_EPOCH=$(stat -c %Y CHANGELOG.md)
export SOURCE_DATE_EPOCH

# make_package FOLDER: prints the name of the package.
make_package() {
  (
    cd "$1" || exit 1
    rm -f build/package/*.deb
    configure package
    build package
    cpack --config build/package/CPackConfig.cmake -B build/package >build/package-cpack.log 2>&1 || {
      cat build/package-cpack.log >&2
      fail "cpack could not make the package"
    }
    ls "$1"/build/package/*.deb
  )
}

package=$(make_package "$root") || exit 1
say "The package is $package."
if [[ ${1:-} != --check ]]; then exit 0; fi

"$root/scripts/install_packages.sh" package-check || exit 1
staged=$(mktemp -d -t mesecina-package.XXXXXX) || fail "cannot write to the temporary folder"
trap 'rm -rf --one-file-system "$staged"' EXIT

say "Checking it with lintian ..."
lintian --fail-on error "$package" || fail "lintian finds errors"
dpkg-deb --extract "$package" "$staged/files"
desktop-file-validate "$staged/files/usr/share/applications/mesecina.desktop" || fail "the desktop entry is not valid"
appstreamcli validate --no-net "$staged"/files/usr/share/metainfo/*.xml || fail "the metadata are not valid"
update-mime-database "$staged/files/usr/share/mime" || fail "the MIME types are not valid"

say "Building it again in another folder ..."
mkdir "$staged/elsewhere"
git ls-files -z --cached --others --exclude-standard | tar -c --null -T - | tar -x -C "$staged/elsewhere"
again=$(make_package "$staged/elsewhere") || exit 1
cmp "$package" "$again" || fail "two builds differ"
say "Both have the same bytes."

say "Installing it on a bare Debian 12 ..."
bare=$staged/bare
log=$root/build/package-bare.log
# Nothing of this machine's environment goes there.
in_bare() { chroot "$bare" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 "$@"; }
{
  debootstrap --variant=minbase bookworm "$bare" &&
    cp "$package" "$bare/tmp" &&
    in_bare apt-get install -y --no-install-recommends "/tmp/$(basename "$package")"
} </dev/null >"$log" 2>&1 || fail "it does not install (all of it: $log)"
in_bare mesecina --version || fail "it does not start"
in_bare mesecina compute /usr/share/mesecina/shapes/lizard.poff --no-timing >"$staged/computed.json" ||
  fail "it does not compute"
build/package/mesecina compute assets/shapes/lizard.poff --no-timing | sed 's|"assets/|"/usr/share/mesecina/|' |
  cmp - "$staged/computed.json" || fail "it computes something else"
in_bare apt-get install -y --no-install-recommends libgl1-mesa-dri </dev/null >>"$log" 2>&1 ||
  fail "what it recommends does not install (all of it: $log)"
in_bare mesecina render /usr/share/mesecina/shapes/lizard.poff -o /tmp/lizard.png || fail "it does not draw"
cp "$bare/tmp/lizard.png" build/package-picture.png
say "It computes and draws there: $root/build/package-picture.png."
