// SPDX-License-Identifier: GPL-3.0-or-later
// The tries for each code, as the core counts them (core/verification/frontal_reading.h).

export const kTries = 72;

/** The reads needed: two in five, rounded up. */
export const kNeeded = Math.floor((2 * kTries + 4) / 5);
