// SPDX-License-Identifier: GPL-3.0-or-later
// The inspector's texts, which the engine draws. Their keys are the English texts in app/inspector/*.cpp. The page loads
// them only with the inspector.
import { currentLanguage } from './catalogue.js';
import { load } from './locales.js';
import { settingTexts } from './setting_names.js';

/**
 * Returns the texts for the engine. The engine has English texts of its own, except for the settings.
 * @returns {Promise<Record<string, string>>}
 */
export const inspectorTexts = async () => ({ ...settingTexts(), ...(await load(currentLanguage(), 'inspector')) });
