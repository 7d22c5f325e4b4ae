// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { fake } from './testing.js';

class Base {
  inherited() {
    return 1;
  }
}
class Real extends Base {
  /** @type {number | undefined} */ size = undefined;
  get isReady() {
    return true;
  }
  /** @param {string} name @param {object} [options] */
  greet(name, options) {
    return options ? name : 'Hello';
  }
}

test('A fake answers the methods and getters of its class and records the calls', () => {
  const double = fake(Real, { greet: (/** @type {string} */ name) => `Hi ${name}`, isReady: false, inherited: 7 });
  assert.equal(double.greet('you', {}), 'Hi you');
  assert.equal(double.inherited(), 7);
  assert.equal(double.isReady, false);
  assert.deepEqual(double.calls, ['greet you', 'inherited']);
});

test('A fake has only the fields that it was given', () => {
  const double = fake(Real, {}, { size: 1 });
  double.size = 2;
  assert.equal(double.size, 2);
  assert.throws(() => fake(Real).size, /Real has no size/);
  assert.throws(() => void (fake(Real).size = 3), /Real has no size/);
});

test('A fake throws on a name that its class lacks', () => {
  const double = /** @type {any} */ (fake(Real));
  assert.throws(() => double.welcome(), /Real has no welcome/);
  assert.throws(() => fake(Real, /** @type {any} */ ({ welcome: 1 })), /Real has no welcome/);
  assert.throws(() => void (double.answers.welcome = 1), /Real has no welcome/);
});
