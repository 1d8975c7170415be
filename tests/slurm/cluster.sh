# A cluster of this machine alone: munged, slurmctld and four virtual nodes, all in one folder. To be sourced.
#   start_cluster FOLDER; export SLURM_CONF=...; kill_node FOLDER n1; stop_cluster FOLDER

# Says why there can be no cluster here; nothing where there can.
no_cluster() {
  local program
  for program in munged slurmctld slurmd sbatch squeue; do
    PATH=$PATH:/usr/sbin command -v "$program" >/dev/null || { echo "$program is not installed (slurm-wlm, munge)"; return; }
  done
  [[ $(id -u) -eq 0 ]] || echo "the daemons of Slurm need root"
}

write_slurm_conf() {
  local where=$1 host port=$((20000 + $$ % 2000 * 6)) i
  host=$(hostname -s)
  cat >"$where/slurm.conf" <<CONF
ClusterName=test
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=$port
SlurmUser=root
AuthType=auth/munge
AuthInfo=socket=$where/munge.socket
StateSaveLocation=$where/state
SlurmctldPidFile=$where/slurmctld.pid
SlurmctldLogFile=$where/slurmctld.log
SlurmdSpoolDir=$where/spool.%n
SlurmdPidFile=$where/slurmd.%n.pid
SlurmdLogFile=$where/slurmd.%n.log
SlurmdParameters=config_overrides
SlurmdTimeout=6
ProctrackType=proctrack/linuxproc
SelectType=select/cons_tres
SelectTypeParameters=CR_CPU
ReturnToService=2
SchedulerParameters=sched_interval=1,bf_interval=1,sched_min_interval=0
PartitionName=main Nodes=ALL Default=YES
CONF
  for i in 1 2 3 4; do
    echo "NodeName=n$i NodeHostname=$host NodeAddr=127.0.0.1 Port=$((port + i)) CPUs=1" >>"$where/slurm.conf"
    mkdir -p "$where/spool.n$i"
  done
}

start_cluster() {
  local where=$1 i
  export SLURM_CONF=$where/slurm.conf
  mkdir -p "$where/state"
  chmod 755 "$where"
  write_slurm_conf "$where"
  (umask 077; head -c 1024 /dev/urandom >"$where/munge.key")
  munged --force --key-file="$where/munge.key" --socket="$where/munge.socket" --pid-file="$where/munged.pid" \
    --log-file="$where/munged.log" --seed-file="$where/munged.seed" 2>/dev/null
  slurmctld
  for i in 1 2 3 4; do slurmd -N "n$i"; done
  for ((i = 0; i < 300; ++i)); do
    [[ $(sinfo --noheader --Node --states=idle --format=%N 2>/dev/null | wc -l) -eq 4 ]] && return
    sleep 0.1
  done
  echo "the cluster does not start:" >&2
  tail -n 20 "$where"/*.log >&2
  return 1
}

# Ids of the tasks that run on a node of this cluster, and of what looks after them.
processes_of() {
  local file
  for file in $(grep -lzxs "SLURMD_NODENAME=$2" /proc/[0-9]*/environ); do
    grep -qzxs "SLURM_CONF=$1/slurm.conf" "$file" && basename "$(dirname "$file")"
  done
  return 0
}

# As if someone had pulled the plug.
kill_node() {
  local where=$1 node=$2 daemon
  daemon=$(cat "$where/slurmd.$node.pid")
  kill -9 "$daemon" $(processes_of "$where" "$node") $(pgrep -P "$daemon") 2>/dev/null || true
}

stop_cluster() {
  local where=$1 file i
  scancel --user=root 2>/dev/null || true
  scontrol shutdown 2>/dev/null || true
  for ((i = 0; i < 50; ++i)); do
    [[ -e $where/slurmctld.pid ]] || break
    sleep 0.1
  done
  for file in "$where"/*.pid; do
    [[ -e $file ]] && kill -9 "$(cat "$file")" 2>/dev/null
  done
  for i in 1 2 3 4; do kill -9 $(processes_of "$where" "n$i") 2>/dev/null; done
  return 0
}
