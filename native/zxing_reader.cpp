// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/zxing_reader.h"

#include <ZXing/ReadBarcode.h>
#include <ZXing/TextUtfEncoding.h>

#include "base/parallel.h"
#include "verification/reading_variants.h"

namespace qrelief {
namespace {

std::optional<SymbolRead> readWith(const GreyImage& picture, ZXing::Binarizer binarizer) {
  const ZXing::ImageView view(picture.pixels.data(), picture.width, picture.height, ZXing::ImageFormat::Lum);
  ZXing::DecodeHints hints;
  hints.setFormats(ZXing::BarcodeFormat::QRCode).setTryHarder(true).setTryRotate(false).setBinarizer(binarizer);
  const ZXing::Result result = ZXing::ReadBarcode(view, hints);
  if (!result.isValid()) return std::nullopt;
  SymbolRead read{ZXing::TextUtfEncoding::ToUtf8(result.text()), result.isMirrored(), {}};
  for (std::size_t k = 0; k < 4; ++k)
    read.corners[k] = {result.position()[static_cast<int>(k)].x, result.position()[static_cast<int>(k)].y};
  return read;
}

}  // namespace

std::vector<SymbolReader> zxingReaders() {
  std::vector<SymbolReader> readers;
  for (const ZXing::Binarizer binarizer : {ZXing::Binarizer::LocalAverage, ZXing::Binarizer::GlobalHistogram})
    readers.emplace_back([binarizer](const GreyImage& picture) { return readWith(picture, binarizer); });
  return readers;
}

std::string readWithZxing(const ReaderView& seen) {
  const std::vector<SymbolReader> readers = zxingReaders();
  for (const GreyImage& variant : readingVariants(seen.picture, seen.pixelsPerModule))
    for (const SymbolReader& reader : readers)
      if (const auto read = reader(variant); read && !read->mirrored) return read->text;
  return {};
}

std::vector<std::string> readFrontal(const ReaderView& seen) {
  const std::vector<SymbolReader> readers = zxingReaders();
  const std::vector<GreyImage> pictures = frontalPictures(seen.luminance, seen.clean.width, seen.pixelsPerModule);
  std::vector<std::string> texts(pictures.size() * readers.size());
  parallelFor(texts.size(), [&](std::size_t i) {
    const auto read = readers[i % readers.size()](pictures[i / readers.size()]);
    if (read && !read->mirrored) texts[i] = read->text;
  });
  return texts;
}

std::string zxingName() { return "ZXing-C++"; }

}  // namespace qrelief
