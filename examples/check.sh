#!/usr/bin/env bash
# Installs a build of Nacre to a scratch folder, then builds the examples against that copy alone,
# runs them, and runs the installed program.
#
#   examples/check.sh BUILD_FOLDER
set -euo pipefail
[[ $# == 1 && -f $1/CMakeCache.txt ]] || {
    echo "usage: check.sh BUILD_FOLDER (configured and built)" >&2
    exit 1
}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

build() { # FOLDER [CMAKE_OPTION...]
    local folder=$scratch/$1
    shift
    cmake -S "$here" -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_PREFIX_PATH="$scratch/nacre" "$@" >"$scratch/log" 2>&1 || {
        cat "$scratch/log" >&2
        exit 1
    }
    ninja -C "$folder" --quiet
}

cmake --install "$1" --prefix "$scratch/nacre" >"$scratch/log"
for header in testing core/embree.h io/hdf5_file.h; do
    [[ ! -e $scratch/nacre/include/nacre/$header ]] || {
        echo "check.sh: include/nacre/$header was installed, but is internal" >&2
        exit 1
    }
done

# Who asks for the core needs none of these.
without=()
for package in embree assimp PkgConfig; do
    without+=("-DCMAKE_DISABLE_FIND_PACKAGE_$package=ON")
done
build core "${without[@]}"
paints=$scratch/nacre/share/nacre/paints
"$scratch/core/brdf_value" "$paints/metallic-gray.toml"
"$scratch/core/multi_angle" "$paints/red-gold.toml" >"$scratch/reading.csv"
[[ $(wc -l <"$scratch/reading.csv") == 7 ]] # a header and six angles
"$scratch/core/fit" "$paints/tio2-mica-110.toml"

build render -DWITH_RENDER=ON
"$scratch/render/picture" "$paints/red-gold.toml" "$scratch/ball.exr"
[[ -s $scratch/ball.exr ]]

"$scratch/nacre/bin/nacre" film --layer TiO2_anatase:80 --substrate mica --wavelength 550
