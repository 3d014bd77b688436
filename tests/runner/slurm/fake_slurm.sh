#!/bin/bash
# Stands for sbatch, squeue, scontrol and scancel, by the name that it is called by. $FAKE_SLURM is a folder:
#   jobs   what Slurm has: a line "NUMBER NAME STATE REASON" for each job
#   calls  what was called
#   TOOL   how a tool misbehaves: a word that is explained where it is handled below; no such file: not at all
tool=$(basename "$0")
cd "$FAKE_SLURM" || exit 99
touch jobs
echo "$tool $*" >> calls
how=$(cat "$tool" 2>/dev/null)
notice() { echo "$tool: NOTICE: maintenance on 4 May, 12 h" >&2; }
fail() { echo "$tool: error: $1" >&2; exit 1; }
unreachable() { fail "slurm_load_jobs: Unable to contact slurm controller (connect failure)"; }

option() {  # NAME: value of --NAME=VALUE
  local word
  for word in "${words[@]}"; do [ "${word%%=*}" = "--$1" ] && echo "${word#*=}"; done
}
words=("$@")

take() {
  id=$((4711 + $(wc -l < jobs)))
  echo "$id $(option job-name) PD None" >> jobs
}

run_sbatch() {
  case $how in
    "") take; echo $id ;;
    notice) notice; echo "Welcome to the cluster"; take; echo $id; echo; echo "$id jobs of yours are waiting" ;;
    cluster) take; echo "$id;fake" ;;
    wordy) take; echo "Submitted batch job $id" ;;                    # a wrapper drops --parsable
    refuses) fail "Batch job submission failed: Invalid partition name specified" ;;
    fails) exit 1 ;;                                                  # without a word
    hangs) sleep 60 ;;
    dies) kill -9 $$ ;;
    timeout) fail "Batch job submission failed: Socket timed out on send/recv operation" ;;
    taken-timeout) take; fail "Batch job submission failed: Socket timed out on send/recv operation" ;;
    taken-refuses) take; fail "Batch job submission failed: Invalid qos specification" ;;
    taken-fails) take; exit 1 ;;
    taken-hangs) take; sleep 60 ;;
    taken-mute) take ;;                                               # succeeds and gives no number
    taken-garbage) take; echo "<html>502 Bad Gateway</html>" ;;
    kills-caller) take; kill -9 $PPID; sleep 0.2; echo $id ;;         # between sbatch and the record
    merge-refused) [[ $(option job-name) == *-merge ]] && fail "Batch job submission failed: QOSMaxSubmitJobPerUserLimit"
      take; echo $id ;;
    merge-taken-fails) take; [[ $(option job-name) == *-merge ]] && exit 1; echo $id ;;
  esac
}

list() {  # the jobs that were asked for
  echo "mpmstudy|JOBID|ST|NAME|REASON"
  [ -n "${SQUEUE_PARTITION:-}" ] && return  # none in that partition
  local names=",$(option name)," ids=",$(option jobs)," id name state reason
  while read -r id name state reason; do
    if [[ $names == *",$name,"* || $ids == *",$id,"* ]]; then echo "mpmstudy|$id|$state|$name|$reason"; fi
  done < jobs
}

run_squeue() {
  case $how in
    "") list ;;
    notice) notice; echo "Welcome to the cluster"; list; echo "Have a nice day" ;;
    unreachable) unreachable ;;
    fails) exit 1 ;;
    hangs) sleep 60 ;;
    mute) ;;                                                          # succeeds and says nothing
    garbage) echo "<html>502 Bad Gateway</html>" ;;
    late-failure) list | head -1; exit 1 ;;                           # begins an answer, then fails
    purged) [ -n "$(option jobs)" ] && fail "slurm_load_jobs error: Invalid job id specified"; list | head -1 ;;
  esac
}

run_scontrol() {
  case $how,$1 in
    ,show) echo "Configuration data as of today"; echo "ClusterName             = fake" ;;
    elsewhere,show) echo "ClusterName             = other" ;;
    private,show) echo "ClusterName             = fake"; echo "PrivateData             = jobs,users" ;;
    ,release) sed -i "s/^\($2 .* \)launch failed requeued held/\1None/" jobs ;;
    refuses,show) echo "ClusterName             = fake" ;;
    refuses,release) fail "Access/permission denied for job $2" ;;
    hangs,*) sleep 60 ;;
    *) unreachable ;;
  esac
}

"run_$tool" "$@"
