#!/usr/bin/env bash
# Renders anew the pictures of docs/ that need nothing but the program, and ImageMagick to put some
# side by side: docs/images/make.sh [program]
# Each single one holds its samples, seed and specimen (exiftool NAME.png shows them). Some minutes.
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
for recipe in paints/effect-pigments/*.toml; do
    paint=$(basename "$recipe" .toml)
    render sphere "effect-pigments/$paint" microflake 160 144 "effect-pigments/$paint.png"
done
for paint in metallic-silver satin-silver tio2-mica-80 tio2-mica-110 ruby glitter-100um; do
    for scene in macro sphere; do
        render "$scene" "$paint" nacre 200 256 "flakes/$scene-$paint.png"
    done
done

printf 'corn-flake-silver-dollar.png\n' >&2
tiles=()
for paint in aluminium-corn-flake aluminium-silver-dollar; do
    "$nacre" render macro --paint "paints/effect-pigments/$paint.toml" --model nacre \
        --size 240x240 --spp 512 --quiet -o "$scratch/$paint.exr"
    tiles+=("$scratch/$paint.png")
done
montage "${tiles[@]}" -tile 2x1 -geometry 240x240+4+4 docs/images/corn-flake-silver-dollar.png

printf 'liquid-metal-chrome.png\n' >&2
tiles=()
for paint in aluminium-pvd aluminium-pvd-chrome; do
    "$nacre" render sphere --paint "paints/effect-pigments/$paint.toml" --model microflake \
        --size 240x240 --spp 512 --quiet -o "$scratch/$paint.exr"
    tiles+=("$scratch/$paint.png")
done
montage "${tiles[@]}" -tile 2x1 -geometry 240x240+4+4 docs/images/liquid-metal-chrome.png

printf 'nacre.png\n' >&2
tiles=()
for scene in macro panel-sun sphere; do
    for paint in metallic-silver tio2-mica-80 tio2-mica-110 glitter-100um ruby; do
        "$nacre" render "$scene" --paint "paints/$paint.toml" --model nacre --size 150x150 \
            --spp 256 --quiet -o "$scratch/$scene-$paint.exr"
        tiles+=("$scratch/$scene-$paint.png")
    done
done
montage "${tiles[@]}" -tile 5x3 -geometry 150x150+0+0 docs/images/nacre.png

printf 'orange-peel.png\n' >&2
# The recipes are those of docs/orange-peel.md.
car='orange_peel = { wa = 0.0002, wb = 0.0003, wc = 0.0006, wd = 0.0012, we = 0.0012 }'
heavy='orange_peel = { wa = 0.0003, wb = 0.0006, wc = 0.002, wd = 0.006, we = 0.005 }'
printf '%s\n' 'ior = 1.5' '[clearcoat]' 'thickness_um = 45' '[[layer]]' 'thickness_um = 15' \
    '[[layer.pigment]]' 'scattering_per_mm = 3' 'absorption_per_mm = 400' >"$scratch/black.toml"
cp paints/metallic-silver.toml "$scratch/silver.toml"
tiles=()
for paint in black silver; do
    stops=0
    if [[ $paint == silver ]]; then stops=-1.5; fi
    for peel in '' "$car" "$heavy"; do
        tile="$scratch/peel-${#tiles[@]}"
        sed "s/^thickness_um = 45/&\n$peel/" "$scratch/$paint.toml" >"$tile.toml"
        "$nacre" render scenes/light-tunnel.toml --paint "$tile.toml" --model nacre --size 280x280 \
            --spp 128 --exposure "$stops" --quiet -o "$tile.exr"
        tiles+=("$tile.png")
    done
done
montage "${tiles[@]}" -tile 3x2 -geometry 280x280+2+2 docs/images/orange-peel.png

printf 'coat-thickness.png\n' >&2
tiles=()
for spread in 0 3 6; do
    tile="$scratch/coat-$spread"
    "$nacre" render scenes/spray-out.toml --paint paints/candy-red.toml --model nacre \
        --set "clearcoat.thickness_spread_um=$spread" --specimen 3 --size 240x200 --spp 64 \
        --exposure -0.5 --quiet -o "$tile.exr"
    tiles+=("$tile.png")
done
montage "${tiles[@]}" -tile 3x1 -geometry 240x200+2+2 docs/images/coat-thickness.png

printf 'orange-peel-door.png\n' >&2
tiles=()
for peel in '' "$car" "$heavy" "$heavy\nroughness = 0.01"; do
    tile="$scratch/door-${#tiles[@]}"
    sed "s/^thickness_um = 45/&\n$peel/" "$scratch/black.toml" >"$tile.toml"
    "$nacre" render scenes/door.toml --paint "$tile.toml" --model microflake --size 400x400 --spp 32 \
        --quiet -o "$tile.exr"
    tiles+=("$tile.png")
done
montage "${tiles[@]}" -tile 2x2 -geometry 400x400+2+2 docs/images/orange-peel-door.png

printf 'sparkle.png\n' >&2
tiles=()
for paint in metallic-silver ruby tio2-mica-110 glitter-100um; do
    field=(--field 3.75 --pixel 25)
    # The glitter of specimen 1 has a flash.
    if [[ $paint == glitter-100um ]]; then field=(--field 9 --pixel 60 --specimen 1); fi
    "$nacre" sparkle "paints/$paint.toml" "${field[@]}" --pictures "$scratch/$paint" --quiet \
        -o "$scratch/sparkle.csv"
    tiles+=("$scratch/$paint/"{15s,45s,75s,diffuse}.png)
done
montage "${tiles[@]}" -tile 4x4 -geometry 150x150+2+2 docs/images/sparkle.png

printf 'sparkle-waviness.png\n' >&2
tiles=()
for slopes in '0 0.16' '0.06 0.1483'; do
    read -r waviness alpha <<<"$slopes"
    "$nacre" sparkle paints/metallic-silver.toml --set diameter_um=36 --set diameter_spread_um=12 \
        --set "waviness=$waviness" --set "orientation.alpha=$alpha" --lamp 15,45 --field 3 --diffuse-samples 0 \
        --pictures "$scratch/waviness-$waviness" --quiet -o "$scratch/sparkle.csv"
    tiles+=("$scratch/waviness-$waviness/"{15s,45s}.png)
done
montage "${tiles[@]}" -tile 4x1 -geometry 240x240+2+2 docs/images/sparkle-waviness.png
