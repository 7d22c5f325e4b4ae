// SPDX-License-Identifier: GPL-3.0-or-later
// The study page. The build makes all of it except the frame (study/page).
import { addTexts } from '../i18n/catalogue.js';
import { study } from '../i18n/parts/study.js';
import { openArticle } from '../guide/article.js';

addTexts({ study });
openArticle();
