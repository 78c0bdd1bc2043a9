#!/usr/bin/env bash
# Installs a build of Nacre to a scratch folder, then builds and runs a small program against that
# copy alone, and the installed program itself.
#
#   cmake/consumer/check.sh BUILD_FOLDER
set -euo pipefail
[[ $# == 1 && -f $1/CMakeCache.txt ]] || {
    echo "usage: check.sh BUILD_FOLDER (configured and built)" >&2
    exit 1
}
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

cmake --install "$1" --prefix "$scratch/nacre" >"$scratch/log"
cmake -S "$here" -B "$scratch/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
    -DCMAKE_PREFIX_PATH="$scratch/nacre" >>"$scratch/log" 2>&1 || {
    cat "$scratch/log" >&2
    exit 1
}
ninja -C "$scratch/build" --quiet
paints=$scratch/nacre/share/nacre/paints
"$scratch/build/consumer" "$paints/metallic-gray.toml"
"$scratch/nacre/bin/nacre" film --layer TiO2_anatase:80 --substrate mica --wavelength 550
