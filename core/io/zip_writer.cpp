// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/zip_writer.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstring>
#include <new>
#include <string>
#include <zlib.h>

#include "base/parallel.h"
#include "io/zip_archive.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

constexpr std::uint16_t kVersionNeeded = 20;  // deflate
constexpr std::uint16_t kUtf8Name = 0x0800;
constexpr std::uint16_t kDate = 1 << 5 | 1;  // 1 January 1980, the format's first day
constexpr int kLevel = 4;                    // text of meshes becomes 6 % larger than with zlib's default, in half the
                                             // time
constexpr int kMemoryLevel = 8;
constexpr std::size_t kSyncFlushBytes = 16;  // at most, that a flush adds
constexpr std::size_t kBlockBytes = 1 << 20, kBlocksAtOnce = 8;
constexpr std::size_t kWindowBytes = 1 << MAX_WBITS;  // how far back deflate looks
constexpr std::size_t kCrcInLocalHeader = 14;
constexpr std::uint64_t kMaxBytes = 0xfffffffe;

using Bytes = std::vector<std::uint8_t>;

template <class T>
void put(Bytes& bytes, T value) {
  std::array<std::uint8_t, sizeof(T)> raw;
  std::memcpy(raw.data(), &value, sizeof(T));
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

void putText(Bytes& bytes, std::string_view text) { bytes.insert(bytes.end(), text.begin(), text.end()); }

/// Returns a part of a raw deflate stream. Parts made apart can be put one after the other [RFC 1951, as pigz].
/// @param window  text before the part, at most kWindowBytes
/// @param flush   Z_FINISH for the last part, else Z_SYNC_FLUSH
Bytes packedBlock(std::string_view window, std::string_view text, int flush) {
  z_stream z{};
  if (deflateInit2(&z, kLevel, Z_DEFLATED, -MAX_WBITS, kMemoryLevel, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::bad_alloc();
  deflateSetDictionary(&z, reinterpret_cast<const Bytef*>(window.data()), static_cast<uInt>(window.size()));
  Bytes packed(deflateBound(&z, text.size()) + kSyncFlushBytes);
  z.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  z.avail_in = static_cast<uInt>(text.size());
  z.next_out = packed.data();
  z.avail_out = static_cast<uInt>(packed.size());
  deflate(&z, flush);
  packed.resize(packed.size() - z.avail_out);
  deflateEnd(&z);
  return packed;
}

}  // namespace

struct ZipWriter::State {
  struct File {
    std::string name;
    std::uint64_t localHeader = 0, size = 0, packedSize = 0;
    std::uint32_t crc = 0;
  };

  Bytes bytes;
  std::vector<File> files;
  bool open = false;
  std::string text;          // of the current file: a window that is packed already, then what is not yet
  std::size_t windowed = 0;  // bytes of the window

  /// Writes the fields that the local header and the directory share.
  void putCommon(const File& file) {
    put<std::uint16_t>(bytes, kVersionNeeded);
    const bool isAscii =
        std::all_of(file.name.begin(), file.name.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
    put<std::uint16_t>(bytes, isAscii ? 0 : kUtf8Name);
    put<std::uint16_t>(bytes, kDeflated);
    put<std::uint16_t>(bytes, 0);  // midnight
    put<std::uint16_t>(bytes, kDate);
    put<std::uint32_t>(bytes, file.crc);
    put(bytes, static_cast<std::uint32_t>(file.packedSize));
    put(bytes, static_cast<std::uint32_t>(file.size));
    put(bytes, static_cast<std::uint16_t>(file.name.size()));
    put<std::uint16_t>(bytes, 0);  // extra fields
  }

  /// Packs what is waiting, its blocks at the same time.
  void pack(bool isEnd) {
    const std::size_t count = std::max<std::size_t>(isEnd, (text.size() - windowed + kBlockBytes - 1) / kBlockBytes);
    std::vector<Bytes> blocks(count);
    parallelFor(count, [&](std::size_t k) {
      const std::size_t begin = windowed + k * kBlockBytes, window = std::min(begin, kWindowBytes);
      const std::string_view all = text;
      blocks[k] = packedBlock(all.substr(begin - window, window), all.substr(begin, kBlockBytes),
                              isEnd && k + 1 == count ? Z_FINISH : Z_SYNC_FLUSH);
    });
    for (const Bytes& block : blocks) bytes.insert(bytes.end(), block.begin(), block.end());
    text.erase(0, text.size() - std::min(text.size(), kWindowBytes));
    windowed = text.size();
  }

  void close() {
    if (!open) return;
    pack(true);
    text.clear();
    windowed = 0;
    open = false;
    File& file = files.back();
    const std::uint64_t begin = file.localHeader + 30 + file.name.size();
    file.packedSize = bytes.size() - begin;
    const std::array<std::uint32_t, 3> numbers = {file.crc, static_cast<std::uint32_t>(file.packedSize),
                                                  static_cast<std::uint32_t>(file.size)};
    std::memcpy(bytes.data() + file.localHeader + kCrcInLocalHeader, numbers.data(), sizeof(numbers));
  }
};

ZipWriter::ZipWriter() : state_(std::make_unique<State>()) {}
ZipWriter::~ZipWriter() = default;

void ZipWriter::begin(std::string_view name) {
  State& s = *state_;
  s.close();
  s.files.push_back({std::string(name), s.bytes.size(), 0, 0, 0});
  put<std::uint32_t>(s.bytes, 0x04034b50);
  s.putCommon(s.files.back());
  putText(s.bytes, name);
  s.open = true;
}

void ZipWriter::append(std::string_view content) {
  State& s = *state_;
  assert(s.open);
  State::File& file = s.files.back();
  file.crc =
      static_cast<std::uint32_t>(crc32_z(file.crc, reinterpret_cast<const Bytef*>(content.data()), content.size()));
  file.size += content.size();
  while (!content.empty()) {
    const std::size_t room = s.windowed + kBlocksAtOnce * kBlockBytes - s.text.size();
    s.text += content.substr(0, room);
    content.remove_prefix(std::min(room, content.size()));
    if (s.text.size() == s.windowed + kBlocksAtOnce * kBlockBytes) s.pack(false);
  }
}

Result<std::vector<std::uint8_t>> ZipWriter::finish() {
  State& s = *state_;
  s.close();
  const std::uint64_t directory = s.bytes.size();
  bool tooLarge = false;
  for (const State::File& file : s.files) {
    tooLarge |= file.size > kMaxBytes;
    put<std::uint32_t>(s.bytes, 0x02014b50);
    put<std::uint16_t>(s.bytes, kVersionNeeded);  // made by
    s.putCommon(file);
    put<std::uint16_t>(s.bytes, 0);  // comment
    put<std::uint16_t>(s.bytes, 0);  // disk
    put<std::uint16_t>(s.bytes, 0);  // attributes
    put<std::uint32_t>(s.bytes, 0);
    put(s.bytes, static_cast<std::uint32_t>(file.localHeader));
    putText(s.bytes, file.name);
  }
  const std::uint64_t size = s.bytes.size() - directory;
  if (tooLarge || s.bytes.size() > kMaxBytes) return fail(ErrorKind::BadUsage, message<"write-3mf-too-large">());
  put<std::uint32_t>(s.bytes, 0x06054b50);
  put<std::uint32_t>(s.bytes, 0);  // disks
  put(s.bytes, static_cast<std::uint16_t>(s.files.size()));
  put(s.bytes, static_cast<std::uint16_t>(s.files.size()));
  put(s.bytes, static_cast<std::uint32_t>(size));
  put(s.bytes, static_cast<std::uint32_t>(directory));
  put<std::uint16_t>(s.bytes, 0);  // comment
  return std::move(s.bytes);
}

}  // namespace qrelief
