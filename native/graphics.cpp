// SPDX-License-Identifier: GPL-3.0-or-later
#include "native/graphics.h"

namespace qrelief {

Graphics Graphics::open() {
  Graphics none{nullptr, nullptr, {gl::kProcessorName, {}, 0}};
  auto context = EglContext::create(true);
  if (!context) return none;
  auto capabilities = gl::queryCapabilities();
  if (!capabilities || gl::isSoftware(capabilities->renderer)) return none;
  auto pass = GeometryPass::create();
  if (!pass) return none;
  return {std::move(*context), std::make_shared<const GeometryPass>(std::move(*pass)), std::move(*capabilities)};
}

}  // namespace qrelief
