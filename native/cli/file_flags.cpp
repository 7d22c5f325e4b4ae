// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/file_flags.h"

#include <fmt/format.h>
#include <map>

#include "io/slicer_names.h"
#include "io/write_3mf.h"

namespace qrelief {

void FileFlags::add(CLI::App& command) {
  std::map<std::string, Slicer> slicers;
  for (const std::string_view name : kSlicerNames) slicers.emplace(name, *slicerByName(name));
  command
      .add_option("--for", slicer_, "any, prusa, orca or bambu: the slicer that will open a two-colour 3MF file [any]")
      ->transform(CLI::CheckedTransformer(slicers).description(""))
      ->option_text("SLICER");
  command.add_flag("--palette", palette_,
                   "list the filaments' colours in a 3MF file for orca or bambu; the file then says that Bambu Studio "
                   "wrote it");
}

Status FileFlags::check() const {
  if (palette_ && !hasPalette(slicer_)) return fail(ErrorKind::BadUsage, message("write-no-palette"));
  return {};
}

WriteOptions FileFlags::writeOptions(const std::string& title, bool ascii) const {
  return {.title = title, .ascii = ascii, .slicer = slicer_, .palette = palette_};
}

std::string FileFlags::text() const {
  // The default hashes as before there was a choice.
  return slicer_ == Slicer::Any ? std::string() : fmt::format(" {} {}", static_cast<int>(slicer_), palette_);
}

}  // namespace qrelief
