// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>

#include "batch/shard.h"

namespace qrelief {

/// Divides the rows of a batch into units, which are carved together: plates, or single rows. Rows and units count
/// from 0; a row's number in the manifest counts from `firstNumber`.
struct BatchLayout {
  std::size_t rows = 0;
  std::size_t perPlate = 0;    ///< rows per plate; 0: no plates
  std::size_t printEvery = 1;  ///< simulate the print of every n-th row, starting with the first
  std::size_t firstNumber = 1;

  std::size_t count() const;
  std::size_t of(std::size_t row) const { return row / together(); }
  std::size_t begin(std::size_t unit) const { return unit * together(); }  ///< first row
  std::size_t end(std::size_t unit) const;                                 ///< one past the last row
  std::size_t rowsOf(const Shard& share) const;

  /// Returns the row of that number; a row beyond all others for a number of none.
  std::size_t rowOf(std::size_t number) const { return number < firstNumber ? rows : number - firstNumber; }

  /// Returns the name of a unit's plate; empty without plates. A series that does not begin at 1 names plates by their
  /// first row's number, so that they do not overwrite those before it.
  std::string plate(std::size_t unit) const;

  bool printsRow(std::size_t row) const { return row % printEvery == 0; }

 private:
  std::size_t together() const { return perPlate > 0 ? perPlate : 1; }
};

}  // namespace qrelief
