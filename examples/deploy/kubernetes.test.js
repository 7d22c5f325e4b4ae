// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { mkdir, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import path from 'node:path';
import { test } from 'node:test';
import { parse } from 'yaml';

const kProject = path.join(import.meta.dirname, '../..');
const manifest = parse(await readFile(path.join(import.meta.dirname, 'kubernetes.yaml'), 'utf8'));

/**
 * What the compiler has against a Job, by the types that kubernetes-types has made of the API's OpenAPI schema: fields that
 * there are not, values of another kind, and what must be there and is not.
 * @param {unknown} job
 * @returns {Promise<string>} empty: nothing
 */
async function faultsOf(job) {
  const build = path.join(kProject, 'build');
  await mkdir(build, { recursive: true });
  const folder = await mkdtemp(path.join(build, 'kubernetes-'));
  try {
    const file = path.join(folder, 'job.ts');
    await writeFile(
      file,
      `import type { Job } from 'kubernetes-types/batch/v1';\nexport const job: Job = ${JSON.stringify(job)};\n`,
    );
    const options = [
      '--noEmit',
      '--strict',
      '--ignoreConfig',
      '--types',
      '',
      '--module',
      'esnext',
      '--moduleResolution',
      'bundler',
    ];
    return await new Promise((resolve) => {
      execFile(path.join(kProject, 'node_modules/.bin/tsc'), [...options, file], (error, out) =>
        resolve(error ? out || error.message : ''),
      );
    });
  } finally {
    await rm(folder, { recursive: true });
  }
}

/** @param {(job: any) => void} change */
function changed(change) {
  const job = structuredClone(manifest);
  change(job);
  return job;
}

test('The manifest is a Job as the Kubernetes API has it', async () => {
  assert.equal(await faultsOf(manifest), '');
});

test('A misspelt field, a value of another kind and a missing template are detected', async () => {
  const [misspelt, kind, missing] = await Promise.all([
    faultsOf(changed((job) => (job.spec.backoffLimitPerIndexes = 3))),
    faultsOf(changed((job) => (job.spec.completions = '8'))),
    faultsOf(changed((job) => delete job.spec.template)),
  ]);
  assert.match(misspelt, /backoffLimitPerIndexes/);
  assert.match(kind, /'string' is not assignable to type 'number'/);
  assert.match(missing, /template/);
});

// Rules of the API that types do not say [kubernetes.io/docs/concepts/workloads/controllers/job].
test('Every index is a share and fails independently', () => {
  const { spec } = manifest;
  assert.equal(spec.completionMode, 'Indexed');
  const [container] = spec.template.spec.containers;
  assert.equal(container.args[container.args.indexOf('--shards') + 1], String(spec.completions));
  assert.ok(spec.backoffLimitPerIndex > 0 && spec.maxFailedIndexes <= spec.completions);
  assert.equal(spec.template.spec.restartPolicy, 'Never');
  const { onExitCodes } = spec.podFailurePolicy.rules.find((/** @type {any} */ rule) => rule.action === 'FailIndex');
  assert.equal(onExitCodes.containerName, container.name);
  // Not 3, which is also that another process still has the share.
  assert.deepEqual(onExitCodes.values, [1, 2]);
});

test('The container needs no privileges and writes only to the mounted folder', () => {
  const pod = manifest.spec.template.spec;
  const [container] = pod.containers;
  assert.equal(pod.securityContext.runAsNonRoot, true);
  assert.deepEqual(container.securityContext, {
    readOnlyRootFilesystem: true,
    allowPrivilegeEscalation: false,
    capabilities: { drop: ['ALL'] },
  });
  const written = container.args[container.args.indexOf('-o') + 1];
  assert.ok(written.startsWith(`${container.volumeMounts[0].mountPath}/`));
});

test('All recipes request the same memory', async () => {
  const [container] = manifest.spec.template.spec.containers;
  const slurm = await readFile(path.join(import.meta.dirname, 'slurm.sh'), 'utf8');
  const aws = await readFile(path.join(import.meta.dirname, 'aws-batch.sh'), 'utf8');
  const parallel = await readFile(path.join(import.meta.dirname, 'parallel.sh'), 'utf8');
  assert.equal(container.resources.requests.memory, '512Mi');
  assert.match(slurm, /--mem=512M\n/);
  assert.match(aws, /"type": "MEMORY", "value": "512"/);
  assert.match(parallel, /--memfree 512M /);
});
