// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/zxing_decoder.h"

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

std::vector<Decoder> zxingDecoders() {
  std::vector<Decoder> decoders;
  for (const ZXing::Binarizer binarizer : {ZXing::Binarizer::LocalAverage, ZXing::Binarizer::GlobalHistogram})
    decoders.emplace_back([binarizer](const GreyImage& picture) { return readWith(picture, binarizer); });
  return decoders;
}

std::string readWithZxing(const ReaderView& seen) {
  const std::vector<Decoder> decoders = zxingDecoders();
  for (const GreyImage& variant : readingVariants(seen.picture, seen.pixelsPerModule))
    for (const Decoder& decoder : decoders)
      if (const auto read = decoder(variant); read && !read->mirrored) return read->text;
  return {};
}

std::vector<std::string> readFrontal(const ReaderView& seen) {
  const std::vector<Decoder> decoders = zxingDecoders();
  const std::vector<GreyImage> pictures = frontalPictures(seen.luminance, seen.pixelsPerModule);
  std::vector<std::string> texts(pictures.size() * decoders.size());
  parallelFor(texts.size(), [&](std::size_t i) {
    const auto read = decoders[i % decoders.size()](pictures[i / decoders.size()]);
    if (read && !read->mirrored) texts[i] = read->text;
  });
  return texts;
}

std::string zxingName() { return "ZXing-C++"; }

}  // namespace qrelief
