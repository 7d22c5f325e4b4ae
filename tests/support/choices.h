// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "base/random.h"

namespace qrelief {

/// Source of a generated case's decisions: the random numbers of a seed, or a fuzzer's bytes. Each decision takes two
/// bytes. Once the bytes have run out, every decision is the first or lowest one.
class Choices {
 public:
  explicit Choices(std::uint64_t seed) : random_(Random(seed)) {}
  explicit Choices(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}

  /// @param bound  1 … 65536
  std::uint32_t below(std::uint32_t bound) {
    if (random_) return static_cast<std::uint32_t>(random_->below(bound));
    return twoBytes() % bound;
  }
  /// Returns a number in [low, high].
  int between(int low, int high) { return low + static_cast<int>(below(static_cast<std::uint32_t>(high - low + 1))); }
  double between(double low, double high) {
    return low + (high - low) * (random_ ? random_->uniform() : twoBytes() / 65535.0);
  }
  bool oneIn(std::uint32_t n) { return below(n) + 1 == n; }

  template <class T, std::size_t Count>
  T of(const std::array<T, Count>& values) {
    return values[below(Count)];
  }

 private:
  std::uint32_t twoBytes() {
    std::uint32_t value = 0;
    for (int k = 0; k < 2 && !bytes_.empty(); ++k) {
      value = value << 8 | bytes_.front();
      bytes_ = bytes_.subspan(1);
    }
    return value;
  }

  std::optional<Random> random_;
  std::span<const std::uint8_t> bytes_;
};

}  // namespace qrelief
