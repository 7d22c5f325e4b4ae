// SPDX-License-Identifier: GPL-3.0-or-later
// What the core counts of each code (core/verification/frontal_reading.h).

export const kTries = 72;

/** Two in five, rounded up. */
export const kNeeded = Math.floor((2 * kTries + 4) / 5);
