// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { otherPrints } from './other_prints.js';

test('Other poses are tried before finer processes, and nothing coarser or the same', () => {
  assert.deepEqual(otherPrints({ process: 'fdm-0.4/0.2', 'build-up': 'as-modelled', layer: '0.2' }, 'facing-slanted'), [
    { buildUp: 'code-up' }, { buildUp: 'code-upright' }, { process: 'fdm-0.4/0.12' }, { process: 'fdm-0.25/0.1' }, { process: 'resin-0.05' },
  ]);
  assert.deepEqual(otherPrints({ process: 'resin-0.05', 'build-up': 'code-up', layer: '0.05' }, 'facing-up'),
    [{ buildUp: 'as-modelled' }, { buildUp: 'code-upright' }]);
});

test('A pose in which the code faces as it was printed is no other way', () => {
  const values = { process: 'resin-0.05', 'build-up': 'as-modelled', layer: '0.05' };
  assert.deepEqual(otherPrints(values, 'facing-up'), [{ buildUp: 'code-upright' }]);
  assert.deepEqual(otherPrints(values, 'facing-aside'), [{ buildUp: 'code-up' }]);
});
