// SPDX-License-Identifier: GPL-3.0-or-later
// What is imported with one language (cut_language.js).
declare module '*/message_catalogues.js?language=en' {
  export const catalogue: Record<string, any>;
}
declare module '*/message_catalogues.js?language=de' {
  export const catalogue: Record<string, any>;
}
