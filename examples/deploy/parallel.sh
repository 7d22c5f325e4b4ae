#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# examples/deploy/parallel.sh SHARES MODEL --list FILE -o FOLDER [more of `qrelief batch`]
# A batch by GNU parallel: one process a core of this machine, or of HOSTS (as `--sshlogin` has them: "a,b,4/c"), which
# must have qrelief and the same folders. Ended at any time, it goes on when run again; JOBS is the log that says where.
set -euo pipefail

shares=$1
shift
remote=()
[[ -z ${HOSTS:-} ]] || remote=(--sshlogin "$HOSTS" --workdir "$PWD" --env QRELIEF_GL)

# A share that is killed is tried again, its rows that are done are not. A share whose rows fail ends with status 1 and
# is tried again, too, in vain but quickly: what failed is not carved again without --retry-failed.
parallel --will-cite --jobs "${PER_HOST:-100%}" --memfree 512M --retries 3 \
  --joblog "${JOBS:-qrelief-jobs.tsv}" --resume-failed "${remote[@]}" \
  qrelief batch "${@@Q}" --quiet --shard "{}/$shares" ::: $(seq 0 $((shares - 1)))

qrelief batch "$@" --merge
