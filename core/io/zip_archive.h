// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>

#include "base/result.h"

namespace qrelief {

/// Ways to keep a file [PKWARE APPNOTE 6.3, §4.4.5].
inline constexpr std::uint16_t kStored = 0, kDeflated = 8;

/// One file of an archive.
struct ZipEntry {
  std::string name;  ///< as the archive has it
  std::uint16_t flags = 0;
  std::uint16_t method = 0;              ///< kStored or kDeflated; others cannot be read
  std::uint32_t crc = 0;                 ///< CRC-32 of the content
  std::uint64_t size = 0;                ///< of the content, bytes
  std::span<const std::uint8_t> packed;  ///< the compressed bytes
};

/// The files of a ZIP archive in memory [PKWARE APPNOTE 6.3], ZIP64 included, found by the central directory only.
///
/// Strict where laxness lets two readers see different files, or one file expand over and over: the local headers must
/// bear out the directory, no two files may share bytes or a name. Nothing is unpacked by opening it.
class ZipArchive {
 public:
  /// @param bytes  the whole archive; has to outlive the archive object
  /// @returns BadInput for anything malformed or on several disks
  static Result<ZipArchive> open(std::span<const std::uint8_t> bytes);

  /// The file of that name, or nullptr; names are compared as OPC asks for [ECMA-376 Part 2, §9.1]: without regard to
  /// ASCII case, and "%20" is a blank.
  const ZipEntry* find(std::string_view name) const;

 private:
  std::map<std::string, ZipEntry> entries_;  ///< by the form of the name that is compared
};

/// Unpacks one file, a bounded piece at a time.
class ZipStream {
 public:
  /// Files that expand to more than `kFreeBytes` must not expand more than `kMaxRatio`-fold; real models in XML expand
  /// 4- to 30-fold, deflate's limit is 1032.
  static constexpr std::uint64_t kMaxRatio = 200;
  static constexpr std::uint64_t kFreeBytes = std::uint64_t{16} << 20;

  /// @returns BadInput if it is encrypted, packed by an unknown method, or expands beyond the limits
  static Result<ZipStream> open(const ZipEntry& entry, std::uint64_t maxBytes);

  ZipStream(ZipStream&&) noexcept;
  ZipStream& operator=(ZipStream&&) noexcept;
  ~ZipStream();

  /// The next piece, valid until the next call; empty at the end.
  /// @returns BadInput if the data is damaged: not what it was packed from, by size or CRC
  Result<std::span<const std::uint8_t>> next();

 private:
  struct State;
  explicit ZipStream(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace qrelief
