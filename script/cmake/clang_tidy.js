// SPDX-License-Identifier: GPL-3.0-or-later
// Runs clang-tidy on the C++ files that the native build has compiled, see script/tidy.
import { execFile, execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { cpus, homedir } from 'node:os';
import { join, relative, resolve, sep } from 'node:path';

/** @typedef {{ file: string, command: string, output: string }} Compilation  of a file that has compiled */

const kProject = resolve('.') + sep;
const kBuild = resolve('build/release');
const kPassed = join(process.env.XDG_CACHE_HOME ?? join(homedir(), '.cache'), 'qrelief', 'clang-tidy');
const kClangTidy = 'clang-tidy-14';

/** @param {string} program @param {string[]} options */
const outputOf = (program, options) => execFileSync(program, options, { encoding: 'utf8', maxBuffer: 1 << 30 });

const withTests = process.argv.includes('--all');

/** True for a file to check; false for a file that the build generated. @param {string} file */
const isMeant = (file) =>
  file.startsWith(kProject) &&
  !file.startsWith(kBuild) &&
  (withTests || !/^(tests|bench)\//.test(relative(kProject, file)));

/** Lists each file in compile_commands.json to check, once. @returns {Compilation[]} */
function compilations() {
  const all = JSON.parse(readFileSync(join(kBuild, 'compile_commands.json'), 'utf8'))
    .filter((/** @type {Compilation} */ { file }) => isMeant(file))
    .map((/** @type {Compilation} */ { file, command }) => ({
      file,
      command,
      output: / -o (\S+) /.exec(command)?.[1],
    }));
  return [...new Map(all.map((/** @type {Compilation} */ one) => [one.file, one])).values()];
}

/** Returns this project's source files of each object, as Ninja stores them. @returns {Map<string, string[]>} */
function sourcesOfObjects() {
  const sources = new Map();
  let current = [];
  for (const line of outputOf('ninja', ['-C', kBuild, '-t', 'deps']).split('\n')) {
    const object = /^(\S+): #deps/.exec(line);
    if (object) sources.set(object[1], (current = []));
    else if (line.startsWith(' ')) current.push(resolve(kBuild, line.trim()));
  }
  return new Map(
    [...sources].map(([object, files]) => [
      object,
      files.filter((/** @type {string} */ file) => file.startsWith(kProject)),
    ]),
  );
}

/** @param {string | Buffer} bytes */
const digest = (bytes) => createHash('sha256').update(bytes).digest('hex');

/** @type {Map<string, string>} */
const digests = new Map();

/** @param {string} file */
function digestOf(file) {
  if (!digests.has(file)) digests.set(file, digest(readFileSync(file)));
  return digests.get(file);
}

/**
 * Names the inputs of the outcome for a file: the rules, its compilation, and all our files that go into it.
 * @returns {(compilation: Compilation) => string} a path
 */
function stampNamer() {
  const sources = sourcesOfObjects();
  const rules = [
    outputOf(kClangTidy, ['--version']),
    ...['.clang-tidy', 'tests/.clang-tidy'].map((file) => digestOf(resolve(file))),
  ];
  return ({ command, output }) => {
    const files = sources.get(output);
    if (!files) throw new Error(`${output} was not built: build the preset release first`);
    const contents = files.map((file) => `${relative(kProject, file)} ${digestOf(file)}`).sort();
    return join(kPassed, digest([...rules, command.replaceAll(kProject, ''), ...contents].join('\n')));
  };
}

/** @param {Compilation} compilation @returns {Promise<string>} its findings, '' if there are none */
const findings = ({ file }) =>
  new Promise((done) => {
    execFile(kClangTidy, ['-p', kBuild, '--quiet', file], { maxBuffer: 1 << 30 }, (failure, out) => {
      done(failure ? out || String(failure) : '');
    });
  });

const all = compilations();
const stampOf = stampNamer();
const stamped = all.map((compilation) => ({ compilation, stamp: stampOf(compilation) }));
const left = stamped.filter(({ stamp }) => !existsSync(stamp));
const [count, passedBefore] = [left.length, all.length - left.length];
mkdirSync(kPassed, { recursive: true });
let failed = 0;

/** Checks files until none is left. */
async function work() {
  for (let next = left.pop(); next; next = left.pop()) {
    const report = await findings(next.compilation);
    if (report) {
      failed += 1;
      console.error(report);
    } else {
      writeFileSync(next.stamp, '');
    }
  }
}

await Promise.all(cpus().map(work));
console.log(
  `clang-tidy looked at ${count} files, ${failed} of them failed; ${passedBefore} have not changed since they passed`,
);
process.exitCode = failed ? 1 : 0;
