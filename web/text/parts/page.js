// SPDX-License-Identifier: GPL-3.0-or-later

export const page = {
  en: {
    ready: 'Ready.',
    cancelled: 'Cancelled. The model is as it was.',
  },
  de: {
    ready: 'Bereit.',
    cancelled: 'Abgebrochen. Das Modell ist, wie es war.',
  },
};
