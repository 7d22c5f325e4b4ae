// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/three_mf/filament_code.h"

#include <gtest/gtest.h>

namespace qrelief {
namespace {

TEST(FilamentCode, IsThatOfTheSlicers) {
  EXPECT_EQ(filamentCode(1), "4");
  EXPECT_EQ(filamentCode(2), "8");
  EXPECT_EQ(filamentCode(3), "0C");
  EXPECT_EQ(filamentCode(4), "1C");
}

TEST(FilamentCode, IsReadBack) {
  for (unsigned filament = 1; filament <= 17; ++filament) EXPECT_EQ(filamentOfCode(filamentCode(filament)), filament);
}

TEST(FilamentCode, DividedFacetsHaveNoFilament) {
  for (const char* code : {"", "0", "1", "8448", "C", "FC", "xC", "2C ", "4\n"}) EXPECT_FALSE(filamentOfCode(code));
}

}  // namespace
}  // namespace qrelief
