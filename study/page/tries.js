// SPDX-License-Identifier: GPL-3.0-or-later
// The core's tries on each code (core/verification/frontal_reading.h).

export const kTries = 72;

/** Tries that must decode: two in five, rounded up. */
export const kNeeded = Math.floor((2 * kTries + 4) / 5);
