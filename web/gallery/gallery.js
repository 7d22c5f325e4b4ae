// SPDX-License-Identifier: GPL-3.0-or-later
// The gallery page. The build makes all of it except the frame (study/gallery).
import { startTexts } from '../i18n/catalogue.js';
import { openArticle } from '../guide/article.js';

await startTexts('gallery');
openArticle();
