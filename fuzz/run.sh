#!/bin/sh
# Builds the fuzz targets with Clang and its sanitizers and runs each for SECONDS (default 30) on
# its seed corpus. What it finds beyond the seeds stays in the build folder. Ends with 1, and leaves
# the input that did it beside, if a target crashes, hangs or takes too much memory.
#
#   fuzz/run.sh [SECONDS [TARGET...]]
set -eu

seconds=${1:-30}
[ $# -gt 0 ] && shift
source_dir=$(cd "$(dirname "$0")/.." && pwd)
build_dir=$source_dir/build-fuzz
targets=${*:-recipe scene mesh solved_paint brdf_table picture_shard rgl merl measurement image material drawdown studio}

cd "$source_dir"
launcher=$(command -v ccache || true)
cmake --preset fuzz -DCMAKE_CXX_COMPILER_LAUNCHER="$launcher" >/dev/null
cmake --build "$build_dir" --target $(for target in $targets; do echo "fuzz_$target"; done)

# Folders with seeds of a target; what Nacre ships serves as well.
seeds() {
    case $1 in
        recipe) shipped=$source_dir/paints ;;
        scene) shipped=$source_dir/scenes ;;
        *) shipped= ;;
    esac
    for folder in "$source_dir/fuzz/corpus/$1" "$shipped"; do
        [ ! -d "$folder" ] || echo "$folder"
    done
}

# Runs one target, and keeps what it prints.
run_target() {
    found="$build_dir/found/$1"
    mkdir -p "$found"
    # Assimp 5.2 loses what it has allocated for a glTF that it refuses halfway.
    leaks=1
    [ "$1" != mesh ] || leaks=0
    # The libraries below are not built with the sanitizer: containers that cross the border would
    # be reported as overflows that are none.
    ASAN_OPTIONS="detect_container_overflow=0:detect_leaks=$leaks" "$build_dir/fuzz/fuzz_$1" \
        -max_total_time="$seconds" -timeout=10 -rss_limit_mb=2048 -print_final_stats=1 \
        -verbosity=0 -close_fd_mask=1 -artifact_prefix="$found/../$1-" \
        "$found" $(seeds "$1") >"$found/../$1.log" 2>&1
}

# As many at once as there are processors.
failed=
set --
for target in $targets end; do
    if [ "$target" = end ] || [ $# -ge "$(nproc)" ]; then
        for pair in "$@"; do
            if wait "${pair#*:}"; then
                echo "fuzz_${pair%%:*}: nothing found in $seconds s"
            else
                cat "$build_dir/found/${pair%%:*}.log"
                failed="$failed ${pair%%:*}"
            fi
        done
        set --
    fi
    [ "$target" != end ] || break
    run_target "$target" &
    set -- "$@" "$target:$!"
done
[ -z "$failed" ] || { echo "failed:$failed; the inputs are in $build_dir/found" >&2; exit 1; }
