#!/usr/bin/env bash
# Renders anew the pictures of docs/ that one command each makes: docs/images/make.sh [program]
# Each holds its samples, seed and specimen (exiftool NAME.png shows them). Some minutes.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/../.."
nacre=${1:-build/nacre}
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT

# render SCENE PAINT MODEL SIZE SAMPLES FILE
render() {
    printf '%s\n' "$6" >&2
    "$nacre" render "$1" --paint "paints/$2.toml" --model "$3" --size "$4x$4" --spp "$5" --quiet \
        -o "$scratch/picture.exr"
    mv "$scratch/picture.png" "docs/images/$6"
}

render sphere red-gold nacre 512 256 sphere.png
for recipe in paints/*.toml; do
    paint=$(basename "$recipe" .toml)
    render sphere "$paint" microflake 256 256 "paints/$paint.png"
done
for paint in metallic-silver satin-silver tio2-mica-80 tio2-mica-110 ruby glitter-100um; do
    for scene in macro sphere; do
        render "$scene" "$paint" nacre 200 256 "flakes/$scene-$paint.png"
    done
done
