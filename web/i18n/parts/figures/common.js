// SPDX-License-Identifier: GPL-3.0-or-later
// Words that all figures use.

export const common = {
  en: {
    asIs: '{value}',
    onAllModels: 'on all {of} models',
    onSomeModels: 'on {holds} of {of} models',
    onNoModel: 'on none of the {of} models',
    inAllCases: 'in all {of} cases',
    inSomeCases: 'in {holds} of {of} cases',
    inNoCase: 'in none of {of} cases',
    download: { one: 'Table with {count} row, CSV', other: 'Table with {count} rows, CSV' },
    failed: {
      one: '{count} of {of} cases could not be engraved and is left out.',
      other: '{count} of {of} cases could not be engraved and are left out.',
    },
    notMeasured: 'This table has not been measured yet, so there is no figure.',
    percent: '{value}\u00a0%',
  },
  de: {
    asIs: '{value}',
    onAllModels: 'bei allen {of} Modellen',
    onSomeModels: 'bei {holds} von {of} Modellen',
    onNoModel: 'bei keinem der {of} Modelle',
    inAllCases: 'in allen {of} Fällen',
    inSomeCases: 'in {holds} von {of} Fällen',
    inNoCase: 'in keinem von {of} Fällen',
    download: { one: 'Tabelle mit {count} Zeile, CSV', other: 'Tabelle mit {count} Zeilen, CSV' },
    failed: {
      one: '{count} von {of} Fällen ließ sich nicht gravieren und fehlt.',
      other: '{count} von {of} Fällen ließen sich nicht gravieren und fehlen.',
    },
    notMeasured: 'Diese Tabelle ist noch nicht gemessen, deshalb fehlt die Abbildung.',
    percent: '{value}\u00a0%',
  },
};
