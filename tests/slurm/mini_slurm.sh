#!/bin/bash
# A Slurm on this machine alone, for tests: mini_slurm.sh up [NODES] | down | kill-controller | start-controller
# Everything lives in $MINI_SLURM, a folder of its own; SLURM_CONF=$MINI_SLURM/slurm.conf is what clients need.
# Wants root and slurmctld, slurmd, slurm-client, munge (Debian). Exit code 77: cannot be started here.
set -u
D=${MINI_SLURM:?a folder}
export SLURM_CONF=$D/slurm.conf
say() { echo "mini_slurm: $*" >&2; }

configuration() {  # NODES
  local host; host=$(hostname -s)
  cat <<EOF
ClusterName=mini
SlurmctldHost=$host(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
CredType=cred/munge
AuthInfo=socket=$D/munge/socket
CommunicationParameters=NoCtldInAddrAny,NoInAddrAny
SlurmctldPort=$PORT
SlurmctldPidFile=$D/slurmctld.pid
SlurmctldLogFile=$D/slurmctld.log
SlurmdPidFile=$D/slurmd.%n.pid
SlurmdLogFile=$D/slurmd.%n.log
SlurmdSpoolDir=$D/spool.%n
StateSaveLocation=$D/state
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
MpiDefault=none
SwitchType=switch/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
SchedulerType=sched/backfill
SchedulerParameters=sched_min_interval=100000,requeue_delay=1
MinJobAge=3600
ReturnToService=2
SlurmdParameters=config_overrides
MailProg=/bin/true
NodeName=n[1-$1] NodeHostname=$host NodeAddr=127.0.0.1 Port=[$((PORT + 1))-$((PORT + $1))] CPUs=2 RealMemory=4000
PartitionName=test Nodes=n[1-$1] Default=YES MaxTime=60 State=UP
EOF
}

start_controller() { slurmctld -f "$SLURM_CONF" "$@"; }

up() {
  local nodes=${1:-2}
  for tool in slurmctld slurmd sbatch squeue munged mungekey; do
    command -v $tool >/dev/null || [ -x /usr/sbin/$tool ] || { say "skipped: $tool is not installed"; return 77; }
  done
  [ "$(id -u)" = 0 ] || { say "skipped: a Slurm can only be started by root"; return 77; }
  PORT=$((20000 + $$ % 20000))
  mkdir -p "$D"/{munge,state} && chmod 755 "$D" "$D/munge"
  for i in $(seq "$nodes"); do mkdir -p "$D/spool.n$i"; done
  configuration "$nodes" > "$SLURM_CONF"
  /usr/sbin/mungekey --create --keyfile="$D/munge.key" --bits=1024 &&
    /usr/sbin/munged --force --key-file="$D/munge.key" --socket="$D/munge/socket" \
      --pid-file="$D/munge/pid" --log-file="$D/munge/log" --seed-file="$D/munge/seed" &&
    start_controller -c || { say "skipped: munge or slurmctld does not start, see $D"; return 77; }
  for i in $(seq "$nodes"); do slurmd -f "$SLURM_CONF" -N "n$i"; done
  for _ in $(seq 240); do
    [ "$(sinfo -h -t idle -o %D 2>/dev/null)" = "$nodes" ] && return 0
    sleep 0.25
  done
  say "skipped: the nodes do not come up, see $D"
  down
  return 77
}

down() {
  scancel -u root 2>/dev/null
  local file
  for file in "$D"/slurmd.*.pid "$D/slurmctld.pid" "$D/munge/pid"; do
    [ -e "$file" ] && kill "$(cat "$file")" 2>/dev/null
  done
  sleep 1
  rm -rf "$D"
}

case ${1:-} in
  up) up "${2:-2}" ;;
  down) down ;;
  kill-controller) kill -9 "$(cat "$D/slurmctld.pid")" ;;
  start-controller) start_controller ;;
  *) say "up [NODES] | down | kill-controller | start-controller"; exit 2 ;;
esac
