#!/usr/bin/env bash
# A picture and an animation rendered by Slurm on two virtual nodes of this machine, with a task that is
# killed on its way: they must be the files of one process, byte for byte.
#
#   apt-get install slurm-wlm munge
#   NACRE_PROGRAM=build/nacre PYTHONPATH=build/python PATH=build/python-tools/bin:$PATH \
#       python/tests/slurm/render.sh
set -euo pipefail
program=$(realpath "$NACRE_PROGRAM")
cd "$(dirname "${BASH_SOURCE[0]}")"
. ./cluster.sh
trap stop_cluster EXIT

work=$CLUSTER/work
mkdir "$work"
cd "$work"
same() { cmp "$1.exr" "$2.exr" && cmp "$1.png" "$2.png"; }
render() { python3 -m nacre.library render "$@" --slurm; }

start_cluster
echo "a picture in 6 shards"
picture=(macro --paint glitter-100um --size 160x120 --sparkle)
"$program" render "${picture[@]}" --spp 24 --quiet -o whole.exr
render "${picture[@]}" --spp 24 --shards 6 -o shards.exr
await_jobs
same whole shards

echo "once more, with a task that is killed and starts again"
render "${picture[@]}" --spp 480 --shards 6 -o rough.exr | tee jobs
job=$(sed -n '1s/^job \([0-9]*\):.*/\1/p' jobs)
until [[ $(squeue --noheader --states=R --format=%K "--jobs=$job") == *0* ]]; do sleep 0.2; done
scontrol requeue "${job}_0"
await_jobs
"$program" render "${picture[@]}" --spp 480 --quiet -o whole.exr
same whole rough

echo "three frames in 2 shards each"
turning=(curved-panel --paint red-gold --spp 8 --size 64x48 --frames 0:2 --turntable shape --step 5)
"$program" render "${turning[@]}" --quiet -o one.exr
render "${turning[@]}" --shards 2 -o turn.exr
await_jobs
for frame in 0000 0001 0002; do same "one.$frame" "turn.$frame"; done
echo "all pictures are those of one process"
