#!/bin/sh
#SBATCH --job-name=dynamy-sweep
#SBATCH --array=1-{{tasks}}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --output={{output}}
# Runs of this sweep as an array of jobs, {{each}} each. Submitted again, it does what is left; in the
# end: dynamy sweep FOLDER --collect. DYNAMY names another program.
DYNAMY=${DYNAMY:-{{program}}}
last=$((SLURM_ARRAY_TASK_ID * {{each}}))
exec "$DYNAMY" sweep {{folder}} --rows "$((last - {{each}} + 1))-$last"
