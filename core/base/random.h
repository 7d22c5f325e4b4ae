// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cassert>
#include <cstdint>

namespace qrelief {

/// Pseudo-random numbers that, unlike the distributions of `<random>`, are the same on every machine, compiler and
/// standard library: SplitMix64 [Steele, Lea, Flood 2014], period 2^64. For sampling, not for secrets.
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// Returns 64 uniform bits.
  std::uint64_t next() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }

  /// Returns a number in [0, 1), a multiple of 2^-53.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

  /// Returns a number in [low, high).
  double uniform(double low, double high) { return low + (high - low) * uniform(); }

  /// Returns a nearly normal number: mean 0, standard deviation 1, within ±6: the sum of twelve uniform numbers
  /// [Irwin-Hall].
  double normal() {
    double sum = -6;
    for (int i = 0; i < 12; ++i) sum += uniform();
    return sum;
  }

  /// Returns a whole number in [0, bound) without bias: numbers below 2^64 mod `bound` are drawn again.
  /// @param bound  ≥ 1
  std::uint64_t below(std::uint64_t bound) {
    assert(bound >= 1);
    const std::uint64_t excess = (0 - bound) % bound;  // 2^64 mod bound
    std::uint64_t drawn = next();
    while (drawn < excess) drawn = next();
    return drawn % bound;
  }

 private:
  std::uint64_t state_;
};

}  // namespace qrelief
