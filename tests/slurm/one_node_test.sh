#!/bin/bash
# A study as an array of four shards on a Slurm of one node, one of them killed and requeued, must
# end with the bytes of a single process. The Slurm runs on loopback with its own ports and without
# authentication: a configuration for this test only.
#
#   one_node_test.sh WALKGRAPH SOURCE_DIR
# Exit code 77: Slurm is not installed, or this is not root.
set -euo pipefail
export PATH=$PATH:/usr/sbin
walkgraph=$1
source_dir=$2
for program in slurmctld slurmd sbatch scontrol squeue; do
  command -v "$program" >/dev/null || { echo "no $program"; exit 77; }
done
[[ $(id -u) -eq 0 ]] || { echo "needs root"; exit 77; }

dir=$(mktemp -d)
pids=()
finish() {
  kill "${pids[@]}" 2>/dev/null || true
  wait 2>/dev/null || true
  rm -rf "$dir"
}
trap finish EXIT

mkdir "$dir/state" "$dir/spool"
cat >"$dir/slurm.conf" <<CONF
ClusterName=walkgraph_test
SlurmctldHost=$(hostname -s)(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/none
CredType=cred/none
AuthInfo=cred_expire=10
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
AccountingStorageType=accounting_storage/none
JobAcctGatherType=jobacct_gather/none
MpiDefault=none
ReturnToService=2
SlurmctldPort=26817
SlurmdPort=26818
StateSaveLocation=$dir/state
SlurmdSpoolDir=$dir/spool
SlurmctldPidFile=$dir/slurmctld.pid
SlurmdPidFile=$dir/slurmd.pid
SlurmctldLogFile=$dir/slurmctld.log
SlurmdLogFile=$dir/slurmd.log
KillWait=1
SlurmdParameters=config_overrides
NodeName=$(hostname -s) NodeAddr=127.0.0.1 CPUs=4 Boards=1 SocketsPerBoard=1 CoresPerSocket=4 ThreadsPerCore=1
PartitionName=test Nodes=$(hostname -s) Default=YES MaxTime=INFINITE State=UP
CONF
export SLURM_CONF=$dir/slurm.conf

slurmctld -D >"$dir/slurmctld.out" 2>&1 & pids+=($!)
slurmd -D >"$dir/slurmd.out" 2>&1 & pids+=($!)
for _ in $(seq 100); do
  sinfo -h -o %T 2>/dev/null | grep -q idle && break
  sleep 0.2
done
sinfo -h -o %T | grep -q idle || { cat "$dir"/*.log; echo "the node did not come up"; exit 1; }

study=(--dataset="$source_dir/data/samples/survey" --folds=2
       --factors=step,fingerprint,map_error,heading_offset,step_scale)
WALKGRAPH=$walkgraph "$source_dir/eval/studies/slurm/submit" 4 --output="$dir/task_%a.log" -- \
  "${study[@]}" --out="$dir/array" >"$dir/job"
job=$(cut -d';' -f1 "$dir/job")

# Kill one task's processes, hard, once it has begun to write.
for _ in $(seq 300); do
  grep -q " done: " "$dir/task_2.log" 2>/dev/null && break
  sleep 0.05
done
pkill -KILL -f -- "--shard=2/4" || { cat "$dir"/task_*.log; echo "nothing to kill"; exit 1; }

# Over when Slurm holds all four tasks for ended. The queue does not say it: a task that is being requeued is
# for a moment in no list, and on a busy machine squeue fails now and then.
ended_tasks() {
  scontrol show job -o "$job" 2>/dev/null |
    grep -cE 'ArrayTaskId=[0-9]+ .*JobState=(COMPLETED|FAILED|CANCELLED|TIMEOUT|NODE_FAIL) ' || true
}
requeued() { scontrol show job -o "${job}_2" 2>/dev/null | grep -q 'JobState=PENDING .* Restarts=1 '; }
waiting_since=
for _ in $(seq 600); do
  [[ $(ended_tasks) -eq 4 ]] && break
  # A requeued job waits for the eligible time that Slurm gives it; the test does not. But Slurm tells credentials
  # apart by the second: one given in that of the requeue counts as revoked, and the job is killed for good.
  if requeued; then
    : "${waiting_since:=$SECONDS}"
    ((SECONDS - waiting_since < 3)) || scontrol update JobId="${job}_2" StartTime=now 2>/dev/null || true
  fi
  sleep 0.2
done
explain() {
  cat "$dir"/task_*.log
  scontrol show job -o "$job" || true
  grep -E 'JobId=|error' "$dir/slurmctld.log" || true
}
scontrol show job -o "${job}_2" | grep -q ' Restarts=1 ' || { explain; echo "not requeued"; exit 1; }

"$walkgraph" ablate "${study[@]}" --out="$dir/single" >/dev/null 2>&1
diff -r --exclude=run "$dir/single" "$dir/array" || { explain; exit 1; }
echo "$(find "$dir/array" -name '*.json' | wc -l) files equal"
