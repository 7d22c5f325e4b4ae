// SPDX-License-Identifier: GPL-3.0-or-later
// The gallery page. The build makes all of it except the frame (study/gallery).
import { addTexts } from '../i18n/catalogue.js';
import { gallery } from '../i18n/parts/gallery.js';
import { openArticle } from '../guide/article.js';

addTexts({ gallery });
openArticle();
