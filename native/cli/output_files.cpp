// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/output_files.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <unistd.h>
#include <utility>

#include "base/unicode.h"
#include "message_codes/command.h"
#include "native/files.h"

namespace qrelief {
namespace {

namespace fs = std::filesystem;

fs::path folderOf(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

/// Returns the path without links, dots and differences that some file systems ignore.
std::string comparable(const std::string& path) {
  std::error_code error;
  const fs::path folder = fs::weakly_canonical(fs::absolute(folderOf(path), error), error);
  return caseFolded((folder / fs::path(path).filename()).string());
}

/// Checks that a file of this name can be written, by beginning one.
Status checkWritable(const std::string& path) {
  std::error_code error;
  const bool exists = fs::exists(path, error);
  if (exists && ::access(path.c_str(), W_OK) != 0)
    return fail(ErrorKind::BadInput,
                message<"file-not-written">(with::term<"path">(path), with::term<"why">(std::strerror(errno))));
  if (const auto file = AtomicFile::create(path); !file) return tl::unexpected(file.error());
  return {};
}

}  // namespace

bool isSameFile(const std::string& path, const std::string& other) {
  std::error_code error;
  if (fs::equivalent(path, other, error)) return true;
  const auto exact = [&](const std::string& file) { return fs::weakly_canonical(fs::absolute(file, error), error); };
  return exact(path) == exact(other);
}

Status checkJson(const std::string& json, const std::string& model) {
  const FileUse input = {"MODEL", model}, output = {"--json", json};
  return checkOutputs(std::span(&input, 1), std::span(&output, 1));
}

Status checkOutputs(std::span<const FileUse> inputs, std::span<const FileUse> outputs) {
  for (std::size_t i = 0; i < outputs.size(); ++i) {
    const FileUse& output = outputs[i];
    if (output.path.empty() || output.path == kStandardStream) continue;
    for (const FileUse& input : inputs)
      if (!input.path.empty() && isSameFile(output.path, input.path))
        return fail(ErrorKind::BadUsage,
                    message<"output-is-input">(with::term<"output">(output.option), with::term<"path">(output.path),
                                               with::term<"input">(input.option)));
    for (std::size_t other = 0; other < i; ++other)
      if (!outputs[other].path.empty() && comparable(output.path) == comparable(outputs[other].path))
        return fail(ErrorKind::BadUsage, message<"output-twice">(with::term<"output">(output.option),
                                                                 with::term<"other">(outputs[other].option),
                                                                 with::term<"path">(output.path)));
  }
  for (const FileUse& output : outputs)
    if (!output.path.empty() && output.path != kStandardStream) QRELIEF_TRY(checkWritable(output.path));
  return {};
}

JsonOutput::JsonOutput(std::string path) : path_(std::move(path)), standardOutput_(nullptr, &std::fclose) {
  if (path_ != kStandardStream) return;
  standardOutput_.reset(::fdopen(::dup(STDOUT_FILENO), "w"));
  ::dup2(STDERR_FILENO, STDOUT_FILENO);
}

Status JsonOutput::write(std::string_view json) const {
  if (!standardOutput_) return writeFileAtomically(path_, json);
  if (std::fwrite(json.data(), 1, json.size(), standardOutput_.get()) == json.size() &&
      std::fflush(standardOutput_.get()) == 0)
    return {};
  return fail(ErrorKind::BadInput,
              message<"file-not-written">(with::term<"path">("The output"), with::term<"why">(std::strerror(errno))));
}

}  // namespace qrelief
