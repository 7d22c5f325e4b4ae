// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/shard_flags.h"

#include <cstdlib>
#include <fmt/format.h>
#include <optional>

#include "message_codes/command.h"

namespace qrelief {
namespace {

std::string variable(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

/// Makes a shard from an index and a count. @param index  counts from `first`
Result<GivenShard> shardOf(const std::string& index, const std::string& first, const std::string& count,
                           const char* from) {
  const auto unknown = [&] {
    return fail(ErrorKind::BadUsage, message<"shard-unknown">(with::quoted<"shard">(fmt::format("{}/{}", index, count)),
                                                              with::term<"from">(from)));
  };
  try {
    const auto shard = Shard::parse(fmt::format("{}/{}", std::stoll(index) - std::stoll(first), std::stoll(count)));
    if (!shard) return unknown();
    return GivenShard{*shard, from};
  } catch (const std::exception&) {  // not a number
    return unknown();
  }
}

}  // namespace

Result<GivenShard> shardFrom(const std::string& flag, std::size_t shards) {
  if (!flag.empty()) {
    const auto shard = Shard::parse(flag);
    if (!shard)
      return fail(ErrorKind::BadUsage,
                  message<"shard-unknown">(with::quoted<"shard">(flag), with::term<"from">("--shard")));
    return GivenShard{*shard, "--shard"};
  }
  const auto counted = [&](const char* name) { return shards > 0 ? std::to_string(shards) : variable(name); };
  if (const std::string index = variable("SLURM_ARRAY_TASK_ID"); !index.empty())
    return shardOf(index, shards > 0 ? "0" : variable("SLURM_ARRAY_TASK_MIN"), counted("SLURM_ARRAY_TASK_COUNT"),
                   "SLURM_ARRAY_TASK_ID");
  if (const std::string index = variable("AWS_BATCH_JOB_ARRAY_INDEX"); !index.empty())
    return shardOf(index, "0", counted("AWS_BATCH_JOB_ARRAY_SIZE"), "AWS_BATCH_JOB_ARRAY_INDEX");
  if (const std::string index = variable("JOB_COMPLETION_INDEX"); !index.empty() && shards > 0)
    return shardOf(index, "0", std::to_string(shards), "JOB_COMPLETION_INDEX");
  if (shards > 1) return fail(ErrorKind::BadUsage, message<"shards-without-index">());
  return GivenShard{};
}

}  // namespace qrelief
