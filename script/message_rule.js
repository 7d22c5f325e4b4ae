// SPDX-License-Identifier: GPL-3.0-or-later
// A rule for ESLint: `message('code', { name: value })` needs a code in locales/ and exactly the values in its words.
import { readFileSync } from 'node:fs';

/** @typedef {string | Record<string, string>} Forms  `count` chooses the form */
/** @typedef {{ says: Forms, hint?: Forms }} Entry */

/** Returns the names of the values in a text, or in its forms. @param {Forms} forms @returns {string[]} */
const namesIn = (forms) =>
  typeof forms === 'string'
    ? [...forms.matchAll(/\{(\w+)\}/g)].map(([, name]) => name)
    : ['count', ...Object.values(forms).flatMap(namesIn)];

/**
 * Returns the names of the values of each message.
 * @param {Record<string, Entry>} entries  by code
 * @returns {Map<string, Set<string>>}
 */
export const valuesByCode = (entries) =>
  new Map(
    Object.entries(entries).map(([code, { says, hint }]) => [
      code,
      new Set([...namesIn(says), ...(hint ? namesIn(hint) : [])]),
    ]),
  );

/** Reads the English messages. @returns {Record<string, Entry>} */
export function readMessages() {
  const { messages } = JSON.parse(readFileSync(new URL('../locales/en.json', import.meta.url), 'utf8'));
  return Object.assign({}, ...Object.values(messages));
}

/**
 * @param {Map<string, Set<string>>} known  names of the values by code
 * @returns {import('eslint').Rule.RuleModule}
 */
export const messageRule = (known) => ({
  meta: {
    type: 'problem',
    schema: [],
    messages: {
      literal: 'The code of a message must be a string literal',
      names: 'The values of a message must be an object literal with plain names',
      unknown: '"{{code}}" has no words in locales/',
      missing: '"{{code}}" needs the value {{name}}',
      surplus: '"{{code}}" has no value {{name}}',
    },
  },
  create: (context) => ({
    CallExpression(node) {
      if (node.callee.type !== 'Identifier' || node.callee.name !== 'message') return;
      const [first, second] = node.arguments;
      if (first?.type !== 'Literal' || typeof first.value !== 'string') {
        context.report({ node, messageId: 'literal' });
        return;
      }
      const code = first.value;
      const needed = known.get(code);
      if (!needed) {
        context.report({ node: first, messageId: 'unknown', data: { code } });
        return;
      }
      const properties = second?.type === 'ObjectExpression' ? second.properties : [];
      const values = properties.flatMap((one) =>
        one.type === 'Property' && one.key.type === 'Identifier' && !one.computed ? [one.key.name] : [],
      );
      if (values.length < properties.length || (second && second.type !== 'ObjectExpression')) {
        context.report({ node: second, messageId: 'names' });
        return;
      }
      for (const name of needed)
        if (!values.includes(name)) context.report({ node, messageId: 'missing', data: { code, name } });
      for (const name of values)
        if (!needed.has(name)) context.report({ node: second, messageId: 'surplus', data: { code, name } });
    },
  }),
});
