// SPDX-License-Identifier: GPL-3.0-or-later
// The worker's side of the client: starts a host on the canvas it is given, then answers verbs.
import { EngineFailure, describeThrown } from './engine_error.js';
import { EngineHost, transferables } from './engine_host.js';

/** @typedef {{ id: number, verb: string, args: any[] }} Request */

const scope = /** @type {any} */ (globalThis);

/** @type {Promise<EngineHost> | undefined} */
let host;

scope.onmessage = async (/** @type {MessageEvent} */ { data }) => {
  const { id, verb, args } = /** @type {Request} */ (data);
  scope.postMessage({ heard: id }); // so that the page knows at once that this worker lives
  try {
    if (verb === 'start') {
      host = EngineHost.create(
        args[0],
        (event) => scope.postMessage(event, 'job' in event ? transferables(event.job) : []),
        args[1],
      );
      await host;
      scope.postMessage({ id, value: undefined });
      return;
    }
    const value = await /** @type {EngineHost} */ (await host).answer(verb, args);
    scope.postMessage({ id, value }, transferables(value));
  } catch (thrown) {
    if (!(thrown instanceof EngineFailure)) console.error(thrown); // a bug: log its stack
    scope.postMessage({ id, error: describeThrown(thrown) });
  }
};
