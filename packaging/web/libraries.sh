#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Compiles the libraries of the browser build with emscripten, each once. scripts/web.sh calls it where emcc is found.
#
#   libraries.sh SOURCES PREFIX JOBS    SOURCES has an unpacked folder for each Debian source package
#
# A library is finished when its stamp in PREFIX names its recipe; what fails says where its log is.
set -uo pipefail
sources=$1 prefix=$2 jobs=$3
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
WEB_CLANG=$(find "$(em-config LLVM_ROOT)" -maxdepth 1 -name 'clang' -o -name 'clang-[0-9]*' | sort -V | tail -n 1)
export WEB_CLANG
mkdir -p "$prefix"/{lib/pkgconfig,include,log,stamp}
export CFLAGS="-O2 -pthread -fwasm-exceptions -sSUPPORT_LONGJMP=wasm" CXXFLAGS
CXXFLAGS=$CFLAGS
export PKG_CONFIG_LIBDIR=$prefix/lib/pkgconfig EM_PKG_CONFIG_PATH=$prefix/lib/pkgconfig

# archive NAME [flag...] -- source...: compiles the sources into libNAME.a.
archive() {
  local name=$1 flags=()
  shift
  while [[ $1 != -- ]]; do
    flags+=("$1")
    shift
  done
  shift
  local folder=$prefix/objects/$name
  mkdir -p "$folder"
  # shellcheck disable=SC2016
  printf '%s\0' "$@" | xargs -0 -P "$jobs" -I{} bash -c \
    'source=$1 folder=$2 compiler=$3; shift 3; [[ $source == *.c ]] || compiler=em++
     exec "$compiler" $CFLAGS "$@" -c "$source" -o "$folder/$(basename "$source").o"' \
    _ {} "$folder" "$here/cc" "${flags[@]}" &&
    rm -f "$prefix/lib/lib$name.a" && emar rcs "$prefix/lib/lib$name.a" "$folder"/*.o
}

# described NAME VERSION LINK: what pkg-config says of a library.
described() {
  printf 'Name: %s\nDescription: %s\nVersion: %s\nCflags: -I%s/include\nLibs: -L%s/lib %s\n' \
    "$1" "$1" "$2" "$prefix" "$prefix" "$3" >"$prefix/lib/pkgconfig/$1.pc"
}

with_cmake() {
  local folder=$1
  shift
  emcmake cmake -S "$folder" -B "$PWD/build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_C_COMPILER="$here/cc" \
    -DCMAKE_INSTALL_PREFIX="$prefix" -DCMAKE_FIND_ROOT_PATH="$prefix" -DBUILD_SHARED_LIBS=OFF \
    -DCMAKE_POLICY_VERSION_MINIMUM=3.5 "$@" &&
    cmake --build build --parallel "$jobs" && cmake --install build
}

with_configure() {
  local folder=$1
  shift
  CC=$here/cc AR=emar RANLIB=emranlib NM=emnm "$folder/configure" --host=none --prefix="$prefix" --disable-shared \
    "$@" &&
    make -j "$jobs" && make install
}

# Limbs of 64 bits, as elsewhere: CGAL's quickest exact numbers need them.
# The configure script looks for the format of doubles in an object file, does not find it in one of WebAssembly, and
# falls back on conversions that lose bits. Debian leaves the manual out.
library_gmp() {
  mkdir -p "$sources/gmp/doc" && printf 'all install:\n' >"$sources/gmp/doc/Makefile.in" &&
    limb=longlong CC_FOR_BUILD=gcc with_configure "$sources/gmp" --disable-assembly \
      gmp_cv_c_double_format='IEEE little endian' && cp "$sources/gmp/gmpxx.h" "$prefix/include/"
}
# Configure scripts that link hundreds of tiny programs would take ten times as long as these libraries.
# sources_of FOLDER MAKEFILE VARIABLE...: the C sources in the folder that the variables list.
sources_of() {
  local folder=$1 makefile=$2 variable
  shift 2
  for variable in "$@"; do
    awk -v name="$variable" '$1 == name { is_in = 1 } is_in { print } !/\\$/ { is_in = 0 }' "$folder/$makefile" |
      tr -s '\\\t ' '\n' | grep '\.c$' | sed "s|^|$folder/|"
  done
}
library_mpfr() {
  local source=$sources/mpfr4/src files
  mapfile -t files < <(sources_of "$source" Makefile.in libmpfr_la_SOURCES)
  printf '#include "generic/mparam.h"\n#define MPFR_TUNE_CASE "generic"\n' >mparam.h
  cp "$source"/{mpfr,mpf2mpfr}.h "$prefix/include/" &&
    archive mpfr -I. -I"$source" -I"$prefix/include" -DHAVE_LITTLE_ENDIAN=1 -DHAVE_STDARG=1 -DHAVE_STDINT_H=1 \
      -DHAVE_INTTYPES_H=1 -DHAVE_INTMAX_T=1 -DHAVE_LONG_LONG=1 -DMPFR_LONG_WITHIN_LIMB=1 -DMPFR_INTMAX_WITHIN_LIMB=1 \
      -DMPFR_USE_THREAD_SAFE=1 -DHAVE_ALLOCA_H=1 -DHAVE_LOCALE_H=1 -DHAVE_WCHAR_H=1 \
      -DHAVE_SYS_TIME_H=1 -DHAVE_ROUND=1 -DHAVE_TRUNC=1 -DHAVE_FLOOR=1 -DHAVE_CEIL=1 -DHAVE_RINT=1 \
      -DHAVE_NEARBYINT=1 -DHAVE_DOUBLE_IEEE_LITTLE_ENDIAN=1 -DMPFR_HAVE_BUILTIN_UNREACHABLE=1 -D__MPFR_WITHIN_MPFR=1 -- "${files[@]}"
}
# The package has no generated configure script.
library_mpfi() {
  touch mpfi_config.h
  cp "$sources"/mpfi/src/mpfi.h "$sources"/mpfi/src/mpfi_io.h "$prefix/include/" &&
    archive mpfi -I. -I"$prefix/include" -I"$sources/mpfi/src" -DHAVE_MPFR_Z_SUB=1 '-DVERSION="1.5"' -- \
      "$sources"/mpfi/src/*.c
}
library_zlib() {
  cp "$sources"/zlib/zlib.h "$sources"/zlib/zconf.h "$prefix/include/" && described zlib 1.2.13 -lz &&
    archive z -DHAVE_UNISTD_H -- \
      "$sources"/zlib/{adler32,compress,crc32,deflate,infback,inffast,inflate,inftrees,trees,uncompr,zutil}.c
}
library_deflate() {
  cp "$sources/libdeflate/libdeflate.h" "$prefix/include/" &&
    archive deflate -I"$sources/libdeflate" -- "$sources"/libdeflate/lib/*.c
}
library_png() {
  cp "$sources/libpng1.6/scripts/pnglibconf.h.prebuilt" "$prefix/include/pnglibconf.h" &&
    cp "$sources"/libpng1.6/{png,pngconf}.h "$prefix/include/" && described libpng 1.6.39 '-lpng -lz' &&
    archive png -I"$prefix/include" -- \
      "$sources"/libpng1.6/png{,error,get,mem,pread,read,rio,rtran,rutil,set,trans,wio,write,wtran,wutil}.c
}
library_jpeg() { with_cmake "$sources/libjpeg-turbo" -DENABLE_SHARED=OFF -DWITH_SIMD=OFF -DWITH_TURBOJPEG=OFF; }
library_pugixml() { with_cmake "$sources/pugixml"; }
library_fmt() { with_cmake "$sources/fmtlib" -DFMT_TEST=OFF -DFMT_DOC=OFF; }
library_polyclipping() {
  mkdir -p "$prefix/include/polyclipping" &&
    cp "$sources/libpolyclipping/cpp/clipper.hpp" "$prefix/include/polyclipping/" &&
    described polyclipping 6.4.2 -lpolyclipping && archive polyclipping -- "$sources/libpolyclipping/cpp/clipper.cpp" &&
    sed -i "s|^Cflags:.*|Cflags: -I$prefix/include/polyclipping|" "$prefix/lib/pkgconfig/polyclipping.pc"
}
library_muparser() { with_cmake "$sources/muparser" -DENABLE_SAMPLES=OFF -DENABLE_OPENMP=OFF; }
library_freetype() {
  with_cmake "$sources/freetype" -DFT_DISABLE_HARFBUZZ=ON -DFT_DISABLE_BROTLI=ON -DFT_DISABLE_BZIP2=ON \
    -DFT_DISABLE_PNG=ON -DFT_REQUIRE_ZLIB=ON
}
library_harfbuzz() {
  mkdir -p "$prefix/include/harfbuzz" && cp "$sources"/harfbuzz/src/hb*.h "$prefix/include/harfbuzz/" &&
    described harfbuzz 6.0.0 -lharfbuzz &&
    archive harfbuzz -DHAVE_PTHREAD -- "$sources/harfbuzz/src/harfbuzz.cc" &&
    sed -i "s|^Cflags:.*|Cflags: -I$prefix/include/harfbuzz|" "$prefix/lib/pkgconfig/harfbuzz.pc"
}
library_imgui() {
  mkdir -p "$prefix/include/imgui/backends" && cp "$sources"/imgui/{,misc/cpp/}*.h "$prefix/include/imgui/" &&
    cp "$sources"/imgui/backends/imgui_impl_{glfw,opengl3}.h "$prefix/include/imgui/backends/" &&
    archive imgui -I"$sources/imgui" -DIMGUI_IMPL_OPENGL_ES3 -- "$sources"/imgui/imgui{,_draw,_tables,_widgets}.cpp \
      "$sources"/imgui/misc/cpp/imgui_stdlib.cpp "$sources"/imgui/backends/imgui_impl_{glfw,opengl3}.cpp
}
library_stb() {
  # Dear ImGui has copies of its own; the library that Debian's needs is empty here.
  mkdir -p "$prefix/include/stb" && cp "$sources"/libstb/*.h "$prefix/include/stb/" && emar rcs "$prefix/lib/libstb.a"
}
# What a browser has itself, or does without (web/core/glyphs/fonts.cpp).
library_browser() {
  described epoxy 1.5 '-sMIN_WEBGL_VERSION=2 -sMAX_WEBGL_VERSION=2' && described egl 1.5 '' &&
    described glfw3 3.3 -sUSE_GLFW=3 && described fontconfig 2.14 ''
}
library_pixman() {
  local source=$sources/pixman/pixman files
  mapfile -t files < <(sources_of "$source" Makefile.sources libpixman_sources)
  sed 's/@PIXMAN_VERSION_MAJOR@/0/; s/@PIXMAN_VERSION_MINOR@/42/; s/@PIXMAN_VERSION_MICRO@/2/' \
    "$source/pixman-version.h.in" >"$prefix/include/pixman-version.h" &&
    cp "$source/pixman.h" "$prefix/include/" && described pixman-1 0.42.2 -lpixman-1 &&
    archive pixman-1 -I"$source" -I"$prefix/include" -DPACKAGE=pixman-1 -DTLS=__thread -DSIZEOF_LONG=4 \
      -DHAVE_PTHREADS=1 -DTOOLCHAIN_SUPPORTS_ATTRIBUTE_CONSTRUCTOR=1 -DHAVE_BUILTIN_CLZ=1 -- "${files[@]}"
}
library_cairo() {
  local source=$sources/cairo/src feature version=1.16.0 files
  mapfile -t files < <(sources_of "$source" Makefile.sources cairo_sources _cairo_font_subset_sources \
    _cairo_pdf_operators_sources _cairo_deflate_stream_sources cairo_ps_sources cairo_pdf_sources cairo_ft_sources)
  printf '#define CAIRO_FEATURES_H\n' >cairo-features.h
  for feature in PS_SURFACE PDF_SURFACE FT_FONT IMAGE_SURFACE RECORDING_SURFACE USER_FONT MIME_SURFACE \
    OBSERVER_SURFACE; do
    printf '#define CAIRO_HAS_%s 1\n' "$feature"
  done >>cairo-features.h
  cp cairo-features.h "$source"/cairo{,-version,-deprecated,-ps,-pdf,-ft}.h "$prefix/include/" &&
    described cairo-ps "$version" '-lcairo -lpixman-1 -lz' && described cairo-ft "$version" -lcairo &&
    sed -i "s|^Cflags:.*|Cflags: -I$prefix/include -I$prefix/include/freetype2|" "$prefix/lib/pkgconfig/cairo-ft.pc" &&
    archive cairo -I. -I"$source" -I"$prefix/include" -I"$prefix/include/freetype2" -Wno-everything \
      -DHAVE_STDINT_H=1 -DHAVE_INTTYPES_H=1 -DHAVE_UNISTD_H=1 -DHAVE_SYS_TYPES_H=1 -DHAVE_STRNDUP=1 -DHAVE_CTIME_R=1 \
      -DHAVE_GMTIME_R=1 -DHAVE_MKSTEMP=1 -DHAVE_UINT64_T=1 -DHAVE_ZLIB=1 -DCAIRO_HAS_PTHREAD=1 \
      -DCAIRO_HAS_REAL_PTHREAD=1 -DHAVE_CXX11_ATOMIC_PRIMITIVES=1 -DSIZEOF_VOID_P=4 -DSIZEOF_LONG=4 \
      -DSIZEOF_LONG_LONG=8 -DSIZEOF_SIZE_T=4 -DHAVE_FT_GLYPHSLOT_EMBOLDEN=1 -DHAVE_FT_LIBRARY_SETLCDFILTER=1 \
      -DHAVE_FT_LOAD_SFNT_TABLE=1 '-DPACKAGE_VERSION="1.16.0"' -- "${files[@]}"
}

failed=0
for name in gmp mpfr mpfi zlib deflate png jpeg pugixml fmt polyclipping muparser freetype harfbuzz stb imgui browser \
  pixman cairo; do
  # A library whose recipe has changed is compiled again.
  recipe=$(declare -f "library_$name" | cksum)
  [[ $(cat "$prefix/stamp/$name" 2>/dev/null) == "$recipe" ]] && continue
  printf 'Compiling %s ...\n' "$name" >&2
  folder=$prefix/work/$name
  rm -rf "$folder" && mkdir -p "$folder" && cd "$folder" || exit 1
  if ("library_$name") >"$prefix/log/$name.log" 2>&1; then
    printf %s "$recipe" >"$prefix/stamp/$name"
    rm -rf "$folder"
  else
    printf '%s could not be compiled; its log is %s\n' "$name" "$prefix/log/$name.log" >&2
    failed=1
  fi
done
exit "$failed"
