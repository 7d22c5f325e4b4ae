// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/zxing_reader.h"

#include <ZXing/ReadBarcode.h>
#include <ZXing/TextUtfEncoding.h>

#include "verification/reading_variants.h"

namespace qrelief {

std::string readWithZxing(const ReaderView& seen) {
  for (const GreyImage& variant : readingVariants(seen.picture, seen.pixelsPerModule)) {
    const ZXing::ImageView view(variant.pixels.data(), variant.width, variant.height, ZXing::ImageFormat::Lum);
    for (const ZXing::Binarizer binarizer : {ZXing::Binarizer::LocalAverage, ZXing::Binarizer::GlobalHistogram}) {
      ZXing::DecodeHints hints;
      hints.setFormats(ZXing::BarcodeFormat::QRCode).setTryHarder(true).setTryRotate(false).setBinarizer(binarizer);
      const ZXing::Result result = ZXing::ReadBarcode(view, hints);
      if (result.isValid()) return ZXing::TextUtfEncoding::ToUtf8(result.text());
    }
  }
  return {};
}

std::string zxingName() { return "ZXing-C++"; }

}  // namespace qrelief
