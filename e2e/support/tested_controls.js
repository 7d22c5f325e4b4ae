// SPDX-License-Identifier: GPL-3.0-or-later
// The ids of all controls that controls.spec.js tests.
import { kOfTheParts } from './batch_controls.js';
import { kOfTheCarving } from './carving_controls.js';
import { kOfTheModel } from './model_controls.js';
import { kOfThePage, kOfTheView } from './page_controls.js';
import { kOfThePlace } from './place_controls.js';
import { kSettings } from './setting_controls.js';

/** Controls while all parts are carved; batch.spec.js checks their effects. */
const kOfTheRun = [
  'parts-first',
  'print-every',
  'carve-all',
  'parts-pause',
  'parts-resume',
  'parts-stop',
  'parts-retry',
  'parts-shown',
  'parts-download',
  'parts-discard',
];

export const kTestedControls = [kOfTheModel, kOfTheParts, kOfThePlace, kOfTheView, kOfTheCarving, kOfThePage, kSettings]
  .flatMap((part) => Object.keys(part))
  .concat(kOfTheRun);
