// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/file_flags.h"

#include <fmt/format.h>
#include <map>

#include "io/sniff_format.h"
#include "io/three_mf/write_3mf.h"
#include "io/write_model.h"
#include "message_codes/command.h"
#include "message_codes/files.h"

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

Status FileFlags::check(const std::string& output) const {
  if (palette_ && !hasPalette(slicer_)) return fail(ErrorKind::BadUsage, message<"write-no-palette">());
  if (slicer_ != Slicer::Any && formatOfName(output) != ModelFormat::ThreeMf)
    return fail(ErrorKind::BadUsage, message<"slicer-is-for-3mf">(with::term<"output">(output)));
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
