// SPDX-License-Identifier: GPL-3.0-or-later
import { App } from './app.js';
import { Notices } from './ui/notices.js';
import { keepOffline } from './offline/updates.js';
import { startTexts, text } from './i18n/catalogue.js';
import { byId } from './dom/dom.js';

await startTexts();
const notices = new Notices(byId('stage', HTMLElement));
await new App(notices).start(new URLSearchParams(location.search));
if (import.meta.env.PROD) {
  await keepOffline((reload) =>
    notices.show('version', text('autosave.newVersion'), [
      { label: text('autosave.reload'), run: reload, primary: true },
      { label: text('autosave.later'), run: () => {} },
    ]),
  );
}
