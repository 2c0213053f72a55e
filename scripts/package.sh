#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Makes Debian packages of the program, of the library, of its headers and of the Python module, and a portable archive of
# the program, in build/package. Builds of one commit give the same bytes, in whatever folder they are made, with the same
# packages of the system.
#
#   scripts/package.sh            installs what is missing, builds, and makes all of them
#   scripts/package.sh --check    and checks them: lintian, desktop files, the bytes of a second build in another folder,
#                                 both programs in a bare Debian 12, and there an example that is built with the headers
#                                 (as root; takes a second build and a download)
#
# The archive holds the program, its assets and documents, the headers that experiments include, and libraries: those that
# a desktop lacks, and apart from them those that it has. It runs where it is unpacked, with glibc 2.36 or a later one.
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

# Libraries that every desktop has, by the beginnings of their names, and those of the compiler. Graphics drivers are made
# for these, so they come first.
desktop='libX|libxcb|libglib-|libgio-|libgobject-|libgmodule-|libmount|libblkid|libselinux|libffi|libpcre2|libexpat|libz\.|'
desktop+='libfontconfig|libfreetype|libbrotli|libpng|libbsd|libmd\.|libstdc\+\+|libgcc_s'
# Libraries of glibc, which are the system's.
system='linux-vdso|ld-linux|libc\.|libm\.|libdl\.|libpthread\.|librt\.'

# make_archive: from build/release into build/package.
make_archive() {
  local version name root_folder library file owner licences packages proj
  version=$(sed -n 's/^CMAKE_PROJECT_VERSION:STATIC=//p' build/release/CMakeCache.txt)
  name=mesecina-$version-$(uname -m)
  root_folder=build/package/$name
  rm -rf "$root_folder" "$root_folder.tar.xz"
  cmake --install build/release --prefix "$root_folder" --strip >build/package-install.log 2>&1 || return 1
  # Experiments are compiled with these.
  mkdir -p "$root_folder/include/mesecina" "$root_folder/lib/desktop" "$root_folder/share/doc/mesecina/licences"
  install -m 644 core/library/mesecina/*.h "$root_folder/include/mesecina" || return 1
  licences=$root_folder/share/doc/mesecina/licences
  # The program loads this one itself when a map needs it.
  proj=$(strings build/release/mesecina | grep -m 1 '^libproj\.so')
  proj=$(ldconfig -p | awk -v name="$proj" '$1 == name { print $NF; exit }')
  [[ -n $proj ]] || fail "the library PROJ is not there"
  packages=()
  while read -r library; do
    if grep -qE "/($desktop)" <<<"$library"; then
      install -m 644 "$library" "$root_folder/lib/desktop"
    else
      install -m 644 "$library" "$root_folder/lib"
    fi
    # Packages of the time before /lib became a link know their files by that name.
    file=$(readlink -f "$library")
    owner=$(dpkg-query --search "$file" "${file#/usr}" 2>/dev/null | head -n 1 | cut -d: -f1)
    [[ -n $owner ]] || fail "no package has $file"
    packages+=("$owner")
    install -m 644 "/usr/share/doc/$owner/copyright" "$licences/$owner"
  done < <({ printf '%s\n' "$proj"; ldd build/release/mesecina "$proj" | awk '$2 == "=>" { print $3 }'; } |
    grep -vE "/($system)" | sort -u)
  # PROJ looks for its database, and for the grids of old systems, here relative to itself.
  mkdir -p "$root_folder/share/proj"
  install -m 644 /usr/share/proj/proj.db /usr/share/proj/*.gsb "$root_folder/share/proj" || return 1
  packages+=(proj-data)
  install -m 644 /usr/share/doc/proj-data/copyright "$licences/proj-data"
  strip --strip-unneeded "$root_folder"/lib/*.so* "$root_folder"/lib/desktop/*.so*
  # Unlike a run path, this one holds for what the libraries need themselves.
  patchelf --force-rpath --set-rpath "\$ORIGIN/../lib" "$root_folder/bin/mesecina" || return 1
  install -m 755 packaging/start.sh "$root_folder/mesecina"
  {
    printf 'The libraries in lib are those of these packages of Debian 12, which has their sources; their licences are beside.\n\n'
    dpkg-query --show --showformat '${source:Package} ${source:Version}: ${Package} ${Version}\n' "${packages[@]}" | sort -u
  } >"$licences/README"
  tar --create --sort=name --mtime="@$SOURCE_DATE_EPOCH" --owner=0 --group=0 --numeric-owner --format=gnu \
    --directory build/package "$name" | xz -9 --threads=1 >"$root_folder.tar.xz" || return 1
  rm -rf "$root_folder"
}

# make_packages FOLDER: prints the names of the package of the program, of the archive, and of the packages of the library
# and of its headers.
make_packages() {
  (
    cd "$1" || exit 1
    mkdir -p build/package
    rm -f build/package/*.deb build/package/*.tar.xz
    configure_program -DMESECINA_PYTHON=ON -DPython3_EXECUTABLE=/usr/bin/python3
    build release --target mesecina mesecina_documents mesecina_library mesecina_python
    make_archive || fail "the archive could not be made"
    # Where zsh and the linker of Debian look.
    configure_program -DMESECINA_ZSH_FOLDER=share/zsh/vendor-completions \
      -DMESECINA_PYTHON_FOLDER=lib/python3/dist-packages \
      -DCMAKE_INSTALL_LIBDIR="lib/$(dpkg-architecture --query DEB_HOST_MULTIARCH)"
    cpack --config build/release/CPackConfig.cmake -B build/package >build/package-cpack.log 2>&1 || {
      cat build/package-cpack.log >&2
      fail "cpack could not make the package"
    }
    configure_program -UMESECINA_ZSH_FOLDER -UMESECINA_PYTHON_FOLDER -UCMAKE_INSTALL_LIBDIR
    ls "$1"/build/package/mesecina_*.deb
    ls "$1"/build/package/*.tar.xz
    ls "$1"/build/package/libmesecina[0-9]*.deb
    ls "$1"/build/package/libmesecina-dev_*.deb
    ls "$1"/build/package/python3-mesecina_*.deb
  )
}

made=$(make_packages "$root") || exit 1
{ read -r package && read -r archive && read -r library && read -r headers && read -r python; } <<<"$made"
say "The package is $package."
say "The archive is $archive."
say "The library is $library, its headers are in $headers, and its Python module in $python."
if [[ ${1:-} != --check ]]; then exit 0; fi

"$root/scripts/install_packages.sh" package-check || exit 1
staged=$(mktemp -d -t mesecina-package.XXXXXX) || fail "cannot write to the temporary folder"
bare=$staged/bare
trap 'umount "$bare/proc" 2>/dev/null; chmod -R u+w "$staged"; rm -rf --one-file-system "$staged"' EXIT

say "Checking it with lintian ..."
lintian --fail-on error "$package" "$library" "$headers" "$python" || fail "lintian finds errors"
dpkg-deb --extract "$package" "$staged/files"
desktop-file-validate "$staged/files/usr/share/applications/mesecina.desktop" || fail "the desktop entry is not valid"
appstreamcli validate --no-net "$staged"/files/usr/share/metainfo/*.xml || fail "the metadata are not valid"
update-mime-database "$staged/files/usr/share/mime" || fail "the MIME types are not valid"

say "Building it again in another folder ..."
mkdir "$staged/elsewhere"
git ls-files -z --cached --others --exclude-standard | tar -c --null -T - | tar -x -C "$staged/elsewhere"
made=$(make_packages "$staged/elsewhere") || exit 1
{ read -r package_again && read -r archive_again && read -r library_again && read -r headers_again &&
  read -r python_again; } <<<"$made"
cmp "$package" "$package_again" || fail "two packages differ"
cmp "$archive" "$archive_again" || fail "two archives differ"
cmp "$library" "$library_again" || fail "two packages of the library differ"
cmp "$headers" "$headers_again" || fail "two packages of the headers differ"
cmp "$python" "$python_again" || fail "two packages of the Python module differ"
say "All have the same bytes."

say "Trying both on a bare Debian 12 ..."
log=$root/build/package-bare.log
# Nothing of this machine's environment goes there.
in_bare() { chroot "$bare" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 "$@"; }
debootstrap --variant=minbase bookworm "$bare" </dev/null >"$log" 2>&1 || fail "there is no bare Debian (all of it: $log)"
# A program finds itself there.
mount -t proc proc "$bare/proc" || fail "/proc cannot be mounted"

build/release/mesecina compute assets/shapes/lizard.poff --no-timing >"$staged/expected.json"
# A point of the old German grid, which needs the database and a grid.
grid_point='SRID=31467;POINT (3548200 5803100)'
build/release/mesecina export - --layer points --format geojson <<<"$grid_point" 2>/dev/null >"$staged/expected.geojson"
# check_computed PROGRAM ASSETS: it computes there what it computes here.
check_computed() {
  in_bare "$1" --version || fail "it does not start"
  in_bare "$1" compute "$2/shapes/lizard.poff" --no-timing >"$staged/computed.json" || fail "it does not compute"
  sed "s|\"assets/|\"$2/|" "$staged/expected.json" | cmp - "$staged/computed.json" || fail "it computes something else"
  in_bare "$1" export - --layer points --format geojson <<<"$grid_point" 2>/dev/null | cmp - "$staged/expected.geojson" ||
    fail "it has other coordinates"
}
# Anywhere, and nothing is written there.
unpacked="/opt/a place/$(basename "$archive" .tar.xz)"
mkdir "$bare/opt/a place"
tar -x -C "$bare/opt/a place" -f "$archive"
chmod -R a-w "$bare/opt/a place"
check_computed "$unpacked/mesecina" "$unpacked/share/mesecina"
# Other programs, such as conda, leave a folder there that may be gone, or have a database of another version.
in_bare env PROJ_LIB=/gone PROJ_DATA=/gone "$unpacked/mesecina" export - --layer points --format geojson \
  <<<"$grid_point" 2>/dev/null | cmp - "$staged/expected.geojson" || fail "it does not find its own database of PROJ"
say "The archive computes without any package."

cp "$package" "$bare/tmp"
in_bare apt-get install -y --no-install-recommends "/tmp/$(basename "$package")" </dev/null >>"$log" 2>&1 ||
  fail "the package does not install (all of it: $log)"
check_computed mesecina /usr/share/mesecina
in_bare apt-get install -y --no-install-recommends libgl1-mesa-dri </dev/null >>"$log" 2>&1 ||
  fail "what it recommends does not install (all of it: $log)"
in_bare mesecina render /usr/share/mesecina/shapes/lizard.poff -o /tmp/lizard.png || fail "it does not draw"
cp "$bare/tmp/lizard.png" build/package-picture.png
in_bare "$unpacked/mesecina" render /usr/share/mesecina/shapes/lizard.poff -o /tmp/portable.png ||
  fail "the archive does not draw"
cmp "$bare/tmp/lizard.png" "$bare/tmp/portable.png" || fail "the archive draws something else"
say "Both compute and draw there: $root/build/package-picture.png."

say "Compiling an experiment there with the headers of the archive, then with those of the package ..."
in_bare apt-get install -y --no-install-recommends g++ cmake make pkg-config </dev/null >>"$log" 2>&1 ||
  fail "the compiler does not install (all of it: $log)"
# check_experiment PROGRAM: it compiles an example and has its layer.
check_experiment() {
  in_bare "$1" list layers --with /usr/share/mesecina/examples/gabriel.cpp | grep '^gabriel ' >/dev/null ||
    fail "it has no layer of an experiment"
}
check_experiment "$unpacked/mesecina"
cp "$library" "$headers" "$bare/tmp"
in_bare apt-get install -y --no-install-recommends "/tmp/$(basename "$library")" "/tmp/$(basename "$headers")" \
  </dev/null >>"$log" 2>&1 || fail "the library does not install (all of it: $log)"
check_experiment mesecina

say "Building an example with the packages of the library there ..."
in_bare sh -c 'cmake -S /usr/share/doc/libmesecina-dev/examples -B /tmp/example && cmake --build /tmp/example' \
  >>"$log" 2>&1 || fail "the example does not build (all of it: $log)"
in_bare /tmp/example/axis_edges /usr/share/mesecina/shapes/lizard.poff >"$staged/edges.csv" || fail "the example fails"
build/release/mesecina export assets/shapes/lizard.poff --layer medial-axis --format csv >"$staged/exported.csv"
[[ $(wc -l <"$staged/edges.csv") == $(wc -l <"$staged/exported.csv") ]] || fail "the example has other edges"
say "The example has the edges of the program."

say "Reading the same axis with Python there ..."
cp "$python" "$bare/tmp"
in_bare apt-get install -y --no-install-recommends "/tmp/$(basename "$python")" </dev/null >>"$log" 2>&1 ||
  fail "the Python module does not install (all of it: $log)"
edges=$(in_bare python3 -c 'import mesecina
session = mesecina.open("/usr/share/mesecina/shapes/lizard.poff")
session.render(width=200).save("/tmp/python.png")
print(len(session.axis.edges))') || fail "the Python module does not work"
((edges + 1 == $(wc -l <"$staged/exported.csv"))) || fail "Python has other edges"
say "Python has the edges of the program."
