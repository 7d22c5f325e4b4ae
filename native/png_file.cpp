// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/png_file.h"

#include <png.h>
#include <string>

#include "message_codes/command.h"

namespace qrelief {

Result<std::vector<std::uint8_t>> encodePng(const GreyImage& image) {
  png_image header{};
  header.version = PNG_IMAGE_VERSION;
  header.width = static_cast<png_uint_32>(image.width);
  header.height = static_cast<png_uint_32>(image.height);
  header.format = PNG_FORMAT_GRAY;
  png_alloc_size_t size = 0;
  std::vector<std::uint8_t> bytes;
  // The first call returns the size of the file.
  if (png_image_write_to_memory(&header, nullptr, &size, 0, image.pixels.data(), 0, nullptr)) {
    bytes.resize(size);
    if (png_image_write_to_memory(&header, bytes.data(), &size, 0, image.pixels.data(), 0, nullptr)) {
      bytes.resize(size);
      return bytes;
    }
  }
  return fail(ErrorKind::Internal, message<"png-not-written">(with::term<"why">(header.message)));
}

}  // namespace qrelief
