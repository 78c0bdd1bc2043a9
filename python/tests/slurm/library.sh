#!/usr/bin/env bash
# A library made by Slurm on two virtual nodes of this machine, once undisturbed and once with a worker
# cancelled and the job that hands out killed: both times it must be the library of a local run.
#
#   apt-get install slurm-wlm munge
#   PYTHONPATH=build/python PATH=build/python-tools/bin:$PATH python/tests/slurm/library.sh
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")"
. ./cluster.sh
trap stop_cluster EXIT

work=$CLUSTER/work
mkdir "$work"
cat >"$work/plan.toml" <<'END'
[library]
name = "Pearls by Slurm"
[record.thumbnails]
ball = { size = 64, samples = 16 }
[[sweep]]
name = "pearls"
base = "tio2-mica-80"
method = "sobol"
count = 40
[sweep.vary]
"coats[0].thickness_nm" = { from = 40, to = 160 }
"orientation.alpha" = { from = 0.08, to = 0.2, scale = "log" }
END
library() { python3 -m nacre.library "$@"; }
records() { find "$1/records" -name record.json 2>/dev/null | wc -l; }

# The rows but for what depends on the clock.
same() {
    python3 - "$1" "$2" <<'END'
import sys
from nacre.library import Catalogue
one, other = (Catalogue(path).table() for path in sys.argv[1:])
timed = ["seconds"]
assert one.num_rows == 40, one.num_rows
assert one.drop_columns(timed).equals(other.drop_columns(timed)), "the catalogues differ"
END
}

start_cluster
echo "local run"
library run "$work/plan.toml" "$work/local" --workers 2

echo "a run by Slurm, 2 workers"
library run "$work/plan.toml" "$work/slurm" --workers 2 --slurm
await_jobs
library status "$work/slurm"
same "$work/local" "$work/slurm"

echo "a run by Slurm, 3 workers, of which one is cancelled, and the job that hands out killed"
library run "$work/plan.toml" "$work/rough" --workers 3 --slurm | tee "$work/jobs"
until (($(records "$work/rough") >= 5)); do sleep 0.2; done
mapfile -t jobs < <(sed -n 's/^job \([0-9]*\):.*/\1/p' "$work/jobs")
scancel "${jobs[1]}_0"
until (($(records "$work/rough") >= 10)); do sleep 0.2; done
scancel --signal=KILL --full "${jobs[0]}"
await_jobs
echo "left after $(records "$work/rough") records; once more"
(($(records "$work/rough") < 40))
library run "$work/plan.toml" "$work/rough" --workers 2 --slurm
await_jobs
library status "$work/rough"
same "$work/local" "$work/rough"
echo "all three libraries are the same"
