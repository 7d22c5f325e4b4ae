// SPDX-License-Identifier: GPL-3.0-or-later
import { test } from 'node:test';
import { RuleTester } from 'eslint';
import { messageRule, valuesByCode } from '../../script/message_rule.js';

const known = valuesByCode({
  plain: { says: 'The file is empty' },
  counted: { says: { one: 'a hole', other: '{count} holes' }, hint: 'Fill it at {at}' },
});

test('The linter compares each message with its words', () => {
  const count = 'count: { count: 1 }';
  new RuleTester().run('message', messageRule(known), {
    valid: [`message('plain')`, `message('counted', { ${count}, at })`, `say('unknown')`],
    invalid: [
      { code: `message('unknown')`, errors: [{ messageId: 'unknown' }] },
      { code: `message(code)`, errors: [{ messageId: 'literal' }] },
      { code: `message('counted', values)`, errors: [{ messageId: 'names' }] },
      { code: `message('counted', { ...values, ${count} })`, errors: [{ messageId: 'names' }] },
      {
        code: `message('counted', { ${count} })`,
        errors: [{ messageId: 'missing', data: { code: 'counted', name: 'at' } }],
      },
      { code: `message('plain', { at })`, errors: [{ messageId: 'surplus', data: { code: 'plain', name: 'at' } }] },
    ],
  });
});
