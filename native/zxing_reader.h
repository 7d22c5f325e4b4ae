// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "verification/frontal_reading.h"
#include "verification/reader_view.h"
#include "verification/symbol_reader.h"

namespace qrelief {

/// Text of the QR Code in a picture as ZXing-C++ reads it in any of its reading variants, with either of its
/// binarisers; empty if it finds none, or only a mirrored one.
std::string readWithZxing(const ReaderView& seen);

/// What each try on each of frontalPictures() gives, on all cores: with each binariser in turn; empty if nothing.
std::vector<std::string> readFrontal(const ReaderView& seen);

/// ZXing-C++ with each of its binarisers, which differ in what they find: local averages and the global histogram.
std::vector<SymbolReader> zxingReaders();

/// "ZXing-C++" and its version, for reports.
std::string zxingName();

}  // namespace qrelief
