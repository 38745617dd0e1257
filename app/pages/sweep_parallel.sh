#!/bin/sh
# All runs of this sweep with GNU parallel, which also knows other machines: --sshlogin in
# PARALLEL_OPTIONS. Started again, it does what is left. DYNAMY names another program.
set -e
DYNAMY=${DYNAMY:-{{program}}}
folder={{folder}}
seq 1 {{runs}} | parallel -q ${PARALLEL_OPTIONS:-} "$DYNAMY" sweep "$folder" --rows "{}"
"$DYNAMY" sweep "$folder" --collect
