#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# sbatch --array=0-99 examples/deploy/slurm.sh MODEL --list FILE -o FOLDER [more of `qrelief batch`]
# A batch as a Slurm array: each task takes its share from Slurm's variables. FOLDER lies where all nodes see it. When all
# have ended: `qrelief batch … --merge`, as a job by `sbatch --dependency=afterany:ID --wrap '…'`.
# A single share is run again by `scontrol requeue ID_INDEX`; as an array of its own (--array=5) only with --shards N beside it,
# since to Slurm that array has one task, which would take the whole batch.
#SBATCH --job-name=qrelief
#SBATCH --array=0-7
#SBATCH --cpus-per-task=1
#SBATCH --mem=512M
#SBATCH --time=12:00:00
#SBATCH --requeue
#SBATCH --open-mode=append
#SBATCH --output=qrelief-%A_%a.log

qrelief batch "$@" --quiet
status=$?
# Slurm itself requeues what is lost with its node; this, what a signal has ended (no memory left, say).
if ((status > 128 && ${SLURM_RESTART_COUNT:-0} < 3)); then
  scontrol requeue "${SLURM_ARRAY_JOB_ID}_$SLURM_ARRAY_TASK_ID"
fi
exit "$status"
