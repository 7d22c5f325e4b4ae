// SPDX-License-Identifier: GPL-3.0-or-later
// The words of all messages of the core and the page: every file of messages/ except the command's. A test checks this.
// The page loads them through message_words.js.
import batch from '../../messages/batch.json' with { type: 'json' };
import engine from '../../messages/engine.json' with { type: 'json' };
import files from '../../messages/files.json' with { type: 'json' };
import graphics from '../../messages/graphics.json' with { type: 'json' };
import model from '../../messages/model.json' with { type: 'json' };
import pageBatch from '../../messages/page_batch.json' with { type: 'json' };
import pageEngine from '../../messages/page_engine.json' with { type: 'json' };
import pageSettings from '../../messages/page_settings.json' with { type: 'json' };
import pipeline from '../../messages/pipeline.json' with { type: 'json' };
import place from '../../messages/place.json' with { type: 'json' };
import printing from '../../messages/printing.json' with { type: 'json' };
import settingsErrors from '../../messages/settings_errors.json' with { type: 'json' };
import stages from '../../messages/stages.json' with { type: 'json' };
import text from '../../messages/text.json' with { type: 'json' };
import verdict from '../../messages/verdict.json' with { type: 'json' };

/** @type {import('./message_words.js').Catalogue} */
export const catalogue = {
  ...batch,
  ...engine,
  ...files,
  ...graphics,
  ...model,
  ...pageBatch,
  ...pageEngine,
  ...pageSettings,
  ...pipeline,
  ...place,
  ...printing,
  ...settingsErrors,
  ...stages,
  ...text,
  ...verdict,
};
