# A Slurm cluster of two virtual nodes on this machine, for the scripts beside this one, which source
# it: `start_cluster` and, at the end, `stop_cluster`. It needs Debian's packages slurm-wlm and munge
# and no configuration of theirs; everything lies in $CLUSTER, and runs under the user's own name.

CLUSTER=$(mktemp -d "${TMPDIR:-/tmp}/nacre-slurm.XXXXXX")
export SLURM_CONF=$CLUSTER/slurm.conf
CLUSTER_PIDS=()

free_port() { python3 -c 'import socket; s = socket.socket(); s.bind(("", 0)); print(s.getsockname()[1])'; }

start_cluster() {
    local tool
    for tool in munged slurmctld slurmd sbatch; do
        PATH=$PATH:/usr/sbin command -v "$tool" >/dev/null || {
            echo "there is no $tool: apt-get install slurm-wlm munge" >&2
            return 1
        }
    done
    chmod 700 "$CLUSTER"
    mkdir -p "$CLUSTER"/{state,munge,spool-node1,spool-node2}
    head -c 1024 /dev/urandom >"$CLUSTER/munge/key"
    chmod 600 "$CLUSTER/munge/key"
    /usr/sbin/munged --foreground --force --key-file="$CLUSTER/munge/key" \
        --socket="$CLUSTER/munge/socket" --pid-file="$CLUSTER/munge/pid" \
        --seed-file="$CLUSTER/munge/seed" 2>"$CLUSTER/munged.err" &
    CLUSTER_PIDS+=($!)
    cat >"$SLURM_CONF" <<END
ClusterName=virtual
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmctldPort=$(free_port)
AuthType=auth/munge
AuthInfo=socket=$CLUSTER/munge/socket
CredType=cred/munge
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
StateSaveLocation=$CLUSTER/state
SlurmctldPidFile=$CLUSTER/slurmctld.pid
SlurmctldLogFile=$CLUSTER/slurmctld.log
SlurmdPidFile=$CLUSTER/slurmd-%n.pid
SlurmdLogFile=$CLUSTER/slurmd-%n.log
SlurmdSpoolDir=$CLUSTER/spool-%n
SlurmdParameters=config_overrides
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
MpiDefault=none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
KillWait=5
SchedulerParameters=sched_interval=2,batch_sched_delay=0
NodeName=node1 NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=$(free_port) CPUs=2 State=UNKNOWN
NodeName=node2 NodeHostname=$(hostname -s) NodeAddr=127.0.0.1 Port=$(free_port) CPUs=2 State=UNKNOWN
PartitionName=all Nodes=node1,node2 Default=YES MaxTime=INFINITE State=UP
END
    local node
    until [[ -S $CLUSTER/munge/socket ]]; do sleep 0.1; done
    /usr/sbin/slurmctld -D 2>"$CLUSTER/slurmctld.err" &
    CLUSTER_PIDS+=($!)
    for node in node1 node2; do
        /usr/sbin/slurmd -D -N "$node" 2>"$CLUSTER/slurmd-$node.err" &
        CLUSTER_PIDS+=($!)
    done
    local tries
    for ((tries = 0; tries < 120; tries++)); do
        [[ $(sinfo --noheader --states=idle --format=%D 2>/dev/null) == 2 ]] && return
        sleep 0.5
    done
    echo "the nodes do not come up:" >&2
    sinfo >&2
    tail -n 5 "$CLUSTER"/*.log "$CLUSTER"/*.err >&2
    return 1
}

# Waits until no job of the cluster runs or waits.
await_jobs() {
    while [[ -n $(squeue --noheader) ]]; do sleep 1; done
}

stop_cluster() {
    scancel --quiet --user="$(id -un)" 2>/dev/null || true
    local pid
    for pid in "${CLUSTER_PIDS[@]}"; do kill "$pid" 2>/dev/null || true; done
    wait "${CLUSTER_PIDS[@]}" 2>/dev/null || true
    rm -rf "$CLUSTER"
}
