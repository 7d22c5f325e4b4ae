// SPDX-License-Identifier: GPL-3.0-or-later
import assert from 'node:assert/strict';
import { afterEach, beforeEach, mock, test } from 'node:test';
import { message } from '../engine/message.js';
import { onLanguage, setLanguage, text } from './catalogue.js';
import { load } from './locales.js';
import { MessageWords, messageWords } from './message_words.js';
import { hintOf, sentenceOf } from './messages.js';
import { asSentence } from './sentences.js';

const kTold = message('no-such-spot', { index: { count: 7 } });
const kSentence = { en: 'The spot index 7 is out of range', de: 'Der Index 7 einer Stelle ist zu groß' };

/** Fetches that end when and how the test decides. */
class Fetches {
  /** @type {string[]} */ asked = [];
  /** @type {(() => void)[]} */ arrive = [];
  /** @type {(() => void)[]} */ fail = [];
  /** @param {string} language @returns {Promise<any>} */
  of(language) {
    this.asked.push(language);
    return new Promise((resolve, reject) => {
      this.arrive.push(() => resolve(load(language, 'messages')));
      this.fail.push(() => reject(new TypeError('Failed to fetch')));
    });
  }
}

/** @type {Fetches} */ let fetches;
/** @type {MessageWords} */ let words;
/** @type {string[]} */ let sentences;
/** Shows a message as a part of the page would. */
const show = () => void sentences.push(sentenceOf(kTold, words.now));
const settled = () =>
  new Promise((resolve) => {
    setImmediate(resolve);
  });

beforeEach(async () => {
  mock.timers.enable({ apis: ['Date', 'setTimeout'] });
  await setLanguage('en');
  fetches = new Fetches();
  words = new MessageWords((language) => fetches.of(language), show);
  sentences = [];
});
afterEach(async () => {
  mock.timers.reset();
  await setLanguage('en');
});

test('Words are fetched with the first message, once, in the chosen language', async () => {
  assert.deepEqual(fetches.asked, []);
  await setLanguage('de');
  show();
  show();
  fetches.arrive[0]();
  await settled();
  show();
  assert.deepEqual(fetches.asked, ['de']);
  assert.deepEqual(sentences, ['', '', kSentence.de, kSentence.de]);
});

test('A message shown before its words arrive is written again; an empty place stays empty', async () => {
  show();
  assert.equal(asSentence(sentences[0]), '');
  fetches.arrive[0]();
  await settled();
  assert.deepEqual(sentences, ['', kSentence.en]);

  sentences = [];
  const others = new MessageWords((language) => fetches.of(language), show);
  const loading = others.load();
  fetches.arrive[1]();
  await loading;
  assert.deepEqual(sentences, []);
  assert.equal(sentenceOf(kTold, others.now), kSentence.en);
});

test('Another language is fetched with its first message; until then the sentence keeps the previous one', async () => {
  show();
  fetches.arrive[0]();
  await settled();
  await setLanguage('de');
  show();
  fetches.arrive[1]();
  await settled();
  await setLanguage('en');
  show();
  assert.deepEqual(sentences, ['', kSentence.en, kSentence.en, kSentence.de, kSentence.en]);
  assert.deepEqual(fetches.asked, ['en', 'de']);
});

test('A language chosen while another one loads gets its own words', async () => {
  show();
  await setLanguage('de');
  show();
  fetches.arrive[1]();
  await settled();
  assert.equal(sentences.at(-1), kSentence.de);
  fetches.arrive[0]();
  await settled();
  assert.equal(sentences.at(-1), kSentence.de);
});

test('If the words cannot be fetched, code and advice are shown, and the next message retries', async () => {
  show();
  fetches.fail[0]();
  await settled();
  assert.deepEqual(sentences, ['', 'no-such-spot index=7']);
  assert.equal(hintOf(kTold, words.now), text('page.noWords'));
  assert.deepEqual(fetches.asked, ['en']);

  mock.timers.setTime(11_000);
  show();
  assert.equal(sentences.at(-1), '');
  fetches.arrive[1]();
  await settled();
  assert.equal(sentences.at(-1), kSentence.en);
});

test('Late words are shown once they arrive, and the wait for them is limited', async () => {
  show();
  const loading = words.load();
  mock.timers.tick(8_000);
  await loading;
  assert.deepEqual(sentences, ['', 'no-such-spot index=7']);
  fetches.arrive[0]();
  await settled();
  assert.deepEqual(sentences, ['', 'no-such-spot index=7', kSentence.en]);
});

test('If another language cannot be fetched, the sentence stays in the previous one', async () => {
  show();
  fetches.arrive[0]();
  await settled();
  await setLanguage('de');
  show();
  fetches.fail[1]();
  await settled();
  assert.equal(sentences.at(-1), kSentence.en);
  assert.deepEqual(fetches.asked, ['en', 'de']);
});

test('Waiting ends when the words arrive or cannot be fetched', async () => {
  const [first, second] = [words.load(), words.load()];
  fetches.fail[0]();
  await Promise.all([first, second]);
  const third = words.load();
  fetches.arrive[1]();
  await third;
  assert.deepEqual(fetches.asked, ['en', 'en']);
  assert.equal(sentenceOf(kTold, words.now), kSentence.en);
});

test('The words of the current language load by themselves and notify listeners', async () => {
  let heard = 0;
  onLanguage(() => void (heard += 1));
  assert.equal(sentenceOf(kTold), '');
  await messageWords.load();
  assert.equal(sentenceOf(kTold), kSentence.en);
  assert.equal(heard, 1);
});
