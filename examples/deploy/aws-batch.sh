#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# IMAGE=… ROLE_ARN=… FILE_SYSTEM=fs-… QUEUE=… examples/deploy/aws-batch.sh SHARES MODEL --list FILE -o FOLDER [more of `qrelief batch`]
# A batch as an AWS Batch array of 2 to 10,000 jobs; job I takes share I. Paths are below /data, an EFS file system. A
# second job merges when all have succeeded; if one has not, submit the same again, and only what is missing is made.
set -euo pipefail

shares=$1
shift
command=$(printf '%s\n' batch "$@" --quiet | jq -R . | jq -cs .)
merge=$(printf '%s\n' batch "$@" --merge | jq -R . | jq -cs '{command: .}')

# Tried again are jobs whose host was lost or that were killed; rows that fail (1) fail again.
definition=$(aws batch register-job-definition --job-definition-name qrelief --type container \
  --platform-capabilities EC2 --query jobDefinitionArn --output text --retry-strategy '{
    "attempts": 4,
    "evaluateOnExit": [
      {"onStatusReason": "Host EC2*", "action": "RETRY"},
      {"onExitCode": "1", "action": "EXIT"}, {"onExitCode": "2", "action": "EXIT"}, {"onReason": "*", "action": "RETRY"}]
  }' --container-properties '{
    "image": "'"$IMAGE"'", "jobRoleArn": "'"$ROLE_ARN"'", "command": '"$command"',
    "resourceRequirements": [{"type": "VCPU", "value": "1"}, {"type": "MEMORY", "value": "512"}],
    "user": "65532", "readonlyRootFilesystem": true, "privileged": false,
    "volumes": [{"name": "data",
      "efsVolumeConfiguration": {"fileSystemId": "'"$FILE_SYSTEM"'", "transitEncryption": "ENABLED"}}],
    "mountPoints": [{"sourceVolume": "data", "containerPath": "/data"}]
  }')

job=$(aws batch submit-job --job-name qrelief --job-queue "$QUEUE" --job-definition "$definition" \
  --array-properties "size=$shares" --query jobId --output text)
aws batch submit-job --job-name qrelief-merge --job-queue "$QUEUE" --job-definition "$definition" \
  --depends-on "jobId=$job" --container-overrides "$merge" --query jobId --output text
