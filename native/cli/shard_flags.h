// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "base/result.h"
#include "batch/shard.h"

namespace qrelief {

/// The share of this process, and its source.
struct GivenShard {
  Shard shard;
  std::string from;  ///< "--shard", or an environment variable; empty: this process has the whole batch
};

/// Returns the share that --shard names. Without it, returns the share that an array job's environment sets: Slurm's
/// SLURM_ARRAY_TASK_ID, _MIN and _COUNT, AWS Batch's AWS_BATCH_JOB_ARRAY_INDEX and _SIZE, or JOB_COMPLETION_INDEX of
/// Kubernetes' Indexed Jobs. Kubernetes does not say how many there are, so it needs `shards`.
/// @param flag    value of --shard; may be empty
/// @param shards  value of --shards; 0: not given. Overrides the environment's count, because a scheduler treats a
///                partial rerun of an array as a new array; shares then count from 0
/// @returns BadUsage for an invalid share
Result<GivenShard> shardFrom(const std::string& flag, std::size_t shards);

}  // namespace qrelief
