// SPDX-License-Identifier: GPL-3.0-or-later
// The page of the study: the build has made all of it but its frame (study/page).
import { addTexts } from '../i18n/catalogue.js';
import { study } from '../i18n/parts/study.js';
import { openArticle } from '../guide/article.js';

addTexts({ study });
openArticle();
