// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/result.h"
#include "batch/shard.h"

namespace qrelief {

/// The share of this process, and who said so.
struct GivenShard {
  Shard shard;
  std::string from;  ///< "--shard", or a variable of the environment; empty: it has the whole
};

/// The share that --shard names; else that of an engine which runs arrays of processes, by the variables that it sets:
/// Slurm's SLURM_ARRAY_TASK_ID, _MIN and _COUNT, AWS Batch's AWS_BATCH_JOB_ARRAY_INDEX and _SIZE, and of Kubernetes'
/// Indexed Jobs JOB_COMPLETION_INDEX with `shards`, as Kubernetes does not say how many there are.
/// @param flag    of --shard; may be empty
/// @param shards  of --shards; 0: not given. How many there are, whatever the engine says: part of an array that is run
///                again is an array of its own to it; shares count from 0 then
/// @returns BadUsage for what is no share
Result<GivenShard> shardFrom(const std::string& flag, std::size_t shards);

}  // namespace qrelief
