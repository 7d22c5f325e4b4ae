// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/result.h"

namespace qrelief {

/// Compression methods [PKWARE APPNOTE 6.3, §4.4.5].
inline constexpr std::uint16_t kStored = 0, kDeflated = 8;

/// One file of an archive.
struct ZipEntry {
  std::string name;  ///< as in the archive
  std::uint16_t flags = 0;
  std::uint16_t method = 0;              ///< kStored or kDeflated; others cannot be read
  std::uint32_t crc = 0;                 ///< CRC-32 of the content
  std::uint64_t size = 0;                ///< size of the content, bytes
  std::span<const std::uint8_t> packed;  ///< compressed bytes
};

/// The files of a ZIP archive in memory [PKWARE APPNOTE 6.3], ZIP64 included. Only the central directory says which
/// files there are.
///
/// Strict where laxness would let two parsers see different files, or one file expand over and over: local headers must
/// match the directory, and no two files may share bytes or a name. Opening an archive unpacks nothing.
class ZipArchive {
 public:
  /// @param bytes  the whole archive; must outlive the archive object
  /// @returns BadInput for anything malformed or split over several disks
  static Result<ZipArchive> open(std::span<const std::uint8_t> bytes);

  /// Returns the file of that name, or nullptr. Compares names as OPC requires [ECMA-376 Part 2, §9.1]: without regard
  /// to ASCII case, and "%20" is a blank. A backslash in the archive is a slash.
  const ZipEntry* find(std::string_view name) const;

  /// Returns all files, folders excluded, in the directory's order.
  std::vector<const ZipEntry*> files() const;

  /// Returns the number of bytes behind the archive's end. Some mail servers and downloads add them.
  std::size_t trailingBytes() const { return trailingBytes_; }

 private:
  std::map<std::string, ZipEntry> entries_;  ///< keys are names in the form used for comparison
  std::vector<std::string> order_;           ///< keys in the directory's order
  std::size_t trailingBytes_ = 0;
};

/// Unpacks one file, a bounded piece at a time.
class ZipStream {
 public:
  /// Files that expand to more than `kFreeBytes` must not expand more than `kMaxRatio`-fold. Real models in XML expand
  /// 4- to 30-fold; the limit of deflate is 1032-fold.
  static constexpr std::uint64_t kMaxRatio = 200;
  static constexpr std::uint64_t kFreeBytes = std::uint64_t{16} << 20;

  /// @returns BadInput if the file is encrypted, uses an unknown compression method or expands beyond the limits
  static Result<ZipStream> open(const ZipEntry& entry, std::uint64_t maxBytes);

  ZipStream(ZipStream&&) noexcept;
  ZipStream& operator=(ZipStream&&) noexcept;
  ~ZipStream();

  /// Returns the next piece; empty at the end. It stays valid during the next call, so that one thread can use it while
  /// another unpacks the piece that follows.
  /// @returns BadInput if the data is damaged, that is, if its size or CRC does not match
  Result<std::span<const std::uint8_t>> next();

 private:
  struct State;
  explicit ZipStream(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// Returns the content of a file of at most `maxBytes`. @returns BadInput as ZipStream
Result<std::vector<std::uint8_t>> unpacked(const ZipEntry& entry, std::uint64_t maxBytes);

}  // namespace qrelief
