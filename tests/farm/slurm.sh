# A Slurm of two nodes on this machine, on loopback only, without systemd; to be sourced. start_slurm starts
# munged, slurmctld and slurmd n1 and n2 (a processor each) with all their files below $cluster, and
# stop_slurm ends them and whatever they started. Sockets' paths have 107 bytes: $cluster must be short.

write_slurm_conf() {
    cat > "$cluster/slurm.conf" << END
ClusterName=farm
SlurmctldHost=$(uname -n)(127.0.0.1)
SlurmctldPort=$port
CommunicationParameters=NoInAddrAny,NoCtldInAddrAny
AuthType=auth/munge
# A lost node's task may start again when its credential has expired: 120 s, unless told otherwise.
AuthInfo=socket=$cluster/munge.socket,cred_expire=5
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
StateSaveLocation=$cluster/state
SlurmdSpoolDir=$cluster/spool-%n
SlurmctldPidFile=$cluster/slurmctld.pid
SlurmdPidFile=$cluster/%n.pid
SlurmctldLogFile=$cluster/slurmctld.log
SlurmdLogFile=$cluster/%n.log
JobCompType=jobcomp/filetxt
JobCompLoc=$cluster/jobs.log
MailProg=/bin/true
MpiDefault=none
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
SchedulerParameters=batch_sched_delay=0,sched_interval=1,sched_min_interval=0
MinJobAge=2
SlurmdTimeout=10
SlurmdParameters=config_overrides
ReturnToService=2
NodeName=n1 NodeAddr=127.0.0.1 Port=$((port + 1)) CPUs=1
NodeName=n2 NodeAddr=127.0.0.1 Port=$((port + 2)) CPUs=1
PartitionName=farm Nodes=ALL Default=YES MaxTime=INFINITE State=UP
END
}

# Whether the pid is still one of this cluster's daemons, and not another program's by now.
is_ours() { grep -qsF "$cluster/" "/proc/$1/cmdline"; }

end_daemon() {
    local pid
    pid=$(cat "$cluster/$1.pid" 2> /dev/null) && is_ours "$pid" || return 0
    kill "$pid"
    for ((i = 0; i < 50; i++)); do
        is_ours "$pid" || return 0
        sleep 0.1
    done
    kill -KILL "$pid"
}

# Processes that the cluster started: what runs in jobs, and what watches over them.
processes_of_cluster() { grep -lzsxF "SLURM_CONF=$cluster/slurm.conf" /proc/[0-9]*/environ | tr -dc '0-9\n'; }

end_what_runs() {
    local pid
    for pid in $(processes_of_cluster); do
        if [[ $(cat "/proc/$pid/comm" 2> /dev/null) == slurmstepd ]] || grep -qzs ^SLURM_JOB_ID= "/proc/$pid/environ"; then
            kill -KILL "$pid" 2> /dev/null || true
        fi
    done
}

stop_slurm() {
    if is_ours "$(cat "$cluster/slurmctld.pid" 2> /dev/null || echo none)"; then
        scancel --quiet --user="$(id -un)" || true
    fi
    for daemon in n1 n2; do end_daemon "$daemon"; done
    end_what_runs
    for daemon in slurmctld munged; do end_daemon "$daemon"; done
}

nodes_idle() { [[ $(sinfo -h -N -o %T 2> /dev/null | grep -cx idle) == 2 ]]; }

start_slurm() {
    export SLURM_CONF=$cluster/slurm.conf
    mkdir -p "$cluster/state"
    write_slurm_conf
    (umask 077 && head -c 128 /dev/urandom > "$cluster/munge.key")
    munged --force --key-file="$cluster/munge.key" --socket="$cluster/munge.socket" \
        --pid-file="$cluster/munged.pid" --log-file="$cluster/munged.log" --seed-file="$cluster/munge.seed" \
        2> "$cluster/munged.err" || { cat "$cluster/munged.err" >&2; return 1; }
    slurmctld -f "$SLURM_CONF"
    for node in n1 n2; do slurmd -N "$node" -f "$SLURM_CONF"; done
    for ((i = 0; i < 300; i++)); do
        nodes_idle && return
        sleep 0.1
    done
    sinfo -N >&2
    tail -n 5 "$cluster"/*.log >&2
    echo "the nodes did not become idle in 30 s" >&2
    return 1
}
