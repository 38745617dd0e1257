#!/bin/sh
# All runs of this sweep with GNU parallel, which also knows other machines: --sshlogin in
# PARALLEL_OPTIONS. Started again, it does what is left. DYNAMY names another program.
# With a number it does that run: parallel calls it so, because it would replace {} in a path.
set -e
program={{program}}
DYNAMY=${DYNAMY:-$program}
folder={{folder}}
if [ $# -gt 0 ]; then
  exec "$DYNAMY" sweep "$folder"{{options}} --rows "$1"
fi
SWEEP_SCRIPT=$folder/parallel.sh
export DYNAMY SWEEP_SCRIPT
seq 1 {{runs}} | parallel --env DYNAMY --env SWEEP_SCRIPT ${PARALLEL_OPTIONS:-} 'sh "$SWEEP_SCRIPT" {}'
exec "$DYNAMY" sweep "$folder" --collect
