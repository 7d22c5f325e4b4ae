// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "verification/decoder.h"
#include "verification/frontal_reading.h"
#include "verification/reader_view.h"

namespace qrelief {

/// Decodes the QR Code in a picture with ZXing-C++, in any of its reading variants, with either of its binarisers.
/// Empty if it finds none, or only a mirrored one.
std::string readWithZxing(const ReaderView& seen);

/// Decodes each of frontalPictures() with each binariser in turn, on all cores; one text per try, empty if it failed.
std::vector<std::string> readFrontal(const ReaderView& seen);

/// Returns ZXing-C++ with each of its binarisers, which find different codes: local averages and the global histogram.
std::vector<Decoder> zxingDecoders();

/// Returns "ZXing-C++", for reports.
std::string zxingName();

}  // namespace qrelief
