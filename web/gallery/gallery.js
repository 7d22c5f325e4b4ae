// SPDX-License-Identifier: GPL-3.0-or-later
// The page of the gallery: the build has made all of it but its frame (study/gallery).
import { addTexts } from '../i18n/catalogue.js';
import { gallery } from '../i18n/parts/gallery.js';
import { openArticle } from '../guide/article.js';

addTexts({ gallery });
openArticle();
