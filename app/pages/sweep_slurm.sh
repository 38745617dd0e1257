#!/bin/sh
#SBATCH --job-name=dynamy-sweep
#SBATCH --array=1-{{tasks}}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --output=/dev/null
# Runs of this sweep as an array of jobs, {{each}} each. Submitted again, it does what is left; in the
# end: dynamy sweep FOLDER --collect. DYNAMY names another program. What a job prints goes to
# slurm-JOB_TASK.txt in the folder of the sweep.
program={{program}}
DYNAMY=${DYNAMY:-$program}
folder={{folder}}
if [ -n "${SLURM_ARRAY_JOB_ID:-}" ]; then
  exec > "$folder/slurm-${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID.txt" 2>&1
fi
last=$((SLURM_ARRAY_TASK_ID * {{each}}))
exec "$DYNAMY" sweep "$folder"{{options}} --rows "$((last - {{each}} + 1))-$last"
