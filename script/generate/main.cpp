// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the generated files that are committed: docs/options.md and web/generated/settings.js. A test checks that they
// are up to date (tests/settings/generated_test.cpp).
#include <cstdio>
#include <fstream>
#include <string>

#include "generate/options_page.h"
#include "generate/settings_module.h"

namespace {

bool writeFile(const std::string& path, const std::string& text) {
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  stream.close();
  if (stream) return true;
  std::fprintf(stderr, "qrelief_generate: %s cannot be written\n", path.c_str());
  return false;
}

}  // namespace

/// Takes the repository's folder as an optional argument.
int main(int argc, char** argv) {
  const std::string root = argc > 1 ? argv[1] : QRELIEF_SOURCE_DIR;
  const bool written = writeFile(root + "/docs/options.md", qrelief::optionsPage()) &&
                       writeFile(root + "/web/generated/settings.js", qrelief::settingsModule());
  return written ? 0 : 1;
}
