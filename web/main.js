// SPDX-License-Identifier: GPL-3.0-or-later
import { App } from './app.js';

void new App().start(new URLSearchParams(location.search));
