// SPDX-License-Identifier: GPL-3.0-or-later
import { textOr } from './catalogue.js';

/** A stage of the core's work in the language chosen; one we have no words for as it comes. @param {string} stage */
export const stageText = (stage) => textOr('stages', stage);
