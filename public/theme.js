// SPDX-License-Identifier: GPL-3.0-or-later
// Before anything is painted: the appearance that was chosen at an earlier visit (web/ui/preferences.js).
try {
  document.documentElement.dataset.theme = localStorage.getItem('qrelief.theme') ?? 'auto';
} catch {
  // No storage: as the system has it.
}
