// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/zip_archive.h"

#include <algorithm>
#include <array>
#include <new>
#include <vector>
#include <zlib.h>

#include "io/parse_number.h"
#include "io/polygon_list.h"
#include "message_codes/files.h"

namespace qrelief {
namespace {

constexpr std::size_t kEndRecordBytes = 22;
constexpr std::size_t kZip64LocatorBytes = 20;
constexpr std::size_t kZip64EndRecordBytes = 56;
constexpr std::size_t kDirectoryHeaderBytes = 46;
constexpr std::size_t kLocalHeaderBytes = 30;
constexpr std::uint32_t kEndSignature = 0x06054b50;
constexpr std::uint32_t kZip64LocatorSignature = 0x07064b50;
constexpr std::uint32_t kZip64EndSignature = 0x06064b50;
constexpr std::uint32_t kDirectorySignature = 0x02014b50;
constexpr std::uint32_t kLocalSignature = 0x04034b50;
constexpr std::uint16_t kZip64Field = 0x0001;
constexpr std::uint32_t kSee64 = 0xffffffff;  // the number is in the ZIP64 record
constexpr std::uint16_t kEncrypted = 0x0001, kSizesFollow = 0x0008;
constexpr std::size_t kPieceBytes = 256 * 1024;

tl::unexpected<Error> damaged(Message what) {
  return badInput(message<"zip-damaged">(with::cause<"cause">(std::move(what))));
}

/// @param what  text that follows the file's name
tl::unexpected<Error> damagedFile(const ZipEntry& entry, Message what) {
  return damaged(message<"zip-file">(with::quoted<"file">(excerpt(entry.name)), with::cause<"cause">(std::move(what))));
}

/// Reads the numbers of a record one after the other. The caller must have checked that the record is complete.
class Fields {
 public:
  explicit Fields(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint16_t u16() { return take<std::uint16_t>(); }
  std::uint32_t u32() { return take<std::uint32_t>(); }
  std::uint64_t u64() { return take<std::uint64_t>(); }
  void skip(std::size_t count) { position_ += count; }
  std::size_t left() const { return bytes_.size() - position_; }

 private:
  template <class T>
  T take() {
    const T value = loadBytes<T>(bytes_.data() + position_);
    position_ += sizeof(T);
    return value;
  }
  std::span<const std::uint8_t> bytes_;
  std::size_t position_ = 0;
};

struct Directory {
  std::uint64_t entries = 0, offset = 0, size = 0;
  std::uint64_t end = 0;  ///< limit that neither the directory nor the files may pass
  std::size_t trailingBytes = 0;
};

/// Returns the end of the archive by an end record: behind the comment of the length that the record states.
std::size_t endOfArchive(std::span<const std::uint8_t> bytes, std::size_t endRecord) {
  return endRecord + kEndRecordBytes + loadBytes<std::uint16_t>(&bytes[endRecord + 20]);
}

/// Returns true if the directory lies where an end record says, right before the record. ZIP64 archives leave the
/// numbers to another record, which lies there in place of the directory.
bool followsDirectory(std::span<const std::uint8_t> bytes, std::size_t endRecord) {
  const std::uint64_t size = loadBytes<std::uint32_t>(&bytes[endRecord + 12]);
  const std::uint64_t offset = loadBytes<std::uint32_t>(&bytes[endRecord + 16]);
  if (offset + size == endRecord)
    return size == 0 || (size >= kDirectoryHeaderBytes &&
                         loadBytes<std::uint32_t>(&bytes[static_cast<std::size_t>(offset)]) == kDirectorySignature);
  return endRecord >= kZip64LocatorBytes &&
         loadBytes<std::uint32_t>(&bytes[endRecord - kZip64LocatorBytes]) == kZip64LocatorSignature;
}

/// Finds the end record. It is the last thing in the file, except for a comment of the length it states [APPNOTE.TXT,
/// 4.3.16]. In a file that programs have lengthened or whose comment is cut off, it is the last record that follows its
/// directory.
Result<std::size_t> findEndRecord(std::span<const std::uint8_t> bytes) {
  if (bytes.size() < kEndRecordBytes) return damaged(message<"zip-too-short">(with::count<"count">(bytes.size())));
  for (std::size_t at = bytes.size() - kEndRecordBytes + 1; at-- > 0;) {
    if (loadBytes<std::uint32_t>(&bytes[at]) != kEndSignature) continue;
    if (endOfArchive(bytes, at) == bytes.size() || followsDirectory(bytes, at)) return at;
  }
  return damaged(message<"zip-no-directory">());
}

Result<Directory> findDirectory64(std::span<const std::uint8_t> bytes, std::size_t endRecord) {
  const std::size_t locator = endRecord - kZip64LocatorBytes;
  Fields fields(bytes.subspan(locator));
  fields.skip(8);
  const std::uint64_t at = fields.u64();
  if (at > locator || locator - at < kZip64EndRecordBytes) return damaged(message<"zip-record-misplaced">());
  Fields record(bytes.subspan(static_cast<std::size_t>(at)));
  if (record.u32() != kZip64EndSignature) return damaged(message<"zip-record-missing">());
  record.skip(8 + 2 + 2 + 4 + 4);
  Directory directory;
  const std::uint64_t entriesHere = record.u64();
  directory.entries = record.u64();
  directory.size = record.u64();
  directory.offset = record.u64();
  directory.end = at;
  if (entriesHere != directory.entries) return damaged(message<"zip-several-disks">());
  return directory;
}

Result<Directory> findDirectory(std::span<const std::uint8_t> bytes) {
  const Result<std::size_t> at = findEndRecord(bytes);
  QRELIEF_TRY(at);
  const bool has64 =
      *at >= kZip64LocatorBytes && loadBytes<std::uint32_t>(&bytes[*at - kZip64LocatorBytes]) == kZip64LocatorSignature;
  Directory directory;
  if (has64) {
    const Result<Directory> directory64 = findDirectory64(bytes, *at);
    if (!directory64) return directory64;
    directory = *directory64;
  } else {
    Fields record(bytes.subspan(*at));
    record.skip(4);
    const std::uint16_t disk = record.u16(), directoryDisk = record.u16();
    const std::uint16_t entriesHere = record.u16();
    directory.entries = record.u16();
    directory.size = record.u32();
    directory.offset = record.u32();
    directory.end = *at;
    if (disk != 0 || directoryDisk != 0 || entriesHere != directory.entries)
      return damaged(message<"zip-several-disks">());
  }
  if (directory.offset > directory.end || directory.end - directory.offset < directory.size)
    return damaged(message<"zip-directory-misplaced">());
  directory.trailingBytes = bytes.size() - std::min(bytes.size(), endOfArchive(bytes, *at));
  return directory;
}

/// A line of the directory, and the start of its file.
struct Listed {
  ZipEntry entry;
  std::uint64_t packedSize = 0, localHeader = 0;
};

/// Reads the numbers that did not fit into 32 bits, in this order.
bool take64(std::span<const std::uint8_t> extra, std::array<std::uint64_t*, 3> numbers) {
  for (Fields fields(extra); fields.left() >= 4;) {
    const std::uint16_t kind = fields.u16();
    const std::uint16_t size = fields.u16();
    if (size > fields.left()) return false;
    if (kind != kZip64Field) {
      fields.skip(size);
      continue;
    }
    std::size_t left = size;
    for (std::uint64_t* number : numbers) {
      if (*number != kSee64) continue;
      if (left < 8) return false;
      *number = fields.u64();
      left -= 8;
    }
    return true;
  }
  return std::none_of(numbers.begin(), numbers.end(), [](const std::uint64_t* n) { return *n == kSee64; });
}

/// Reads a line and moves on to the next.
Result<Listed> readListed(std::span<const std::uint8_t>& lines, std::uint64_t number) {
  const auto bad = [&](Message what) {
    return damaged(
        message<"zip-directory-line">(with::index<"line">(number + 1), with::cause<"cause">(std::move(what))));
  };
  if (lines.size() < kDirectoryHeaderBytes || loadBytes<std::uint32_t>(lines.data()) != kDirectorySignature)
    return bad(message<"zip-line-missing">());
  Fields fields(lines);
  Listed listed;
  fields.skip(8);
  listed.entry.flags = fields.u16();
  listed.entry.method = fields.u16();
  fields.skip(4);  // time and date
  listed.entry.crc = fields.u32();
  listed.packedSize = fields.u32();
  listed.entry.size = fields.u32();
  const std::size_t nameSize = fields.u16(), extraSize = fields.u16(), commentSize = fields.u16();
  const std::uint16_t disk = fields.u16();
  fields.skip(2 + 4);  // attributes
  listed.localHeader = fields.u32();
  const std::size_t size = kDirectoryHeaderBytes + nameSize + extraSize + commentSize;
  if (lines.size() < size) return bad(message<"zip-line-cut-off">());
  if (disk != 0) return bad(message<"zip-line-other-disk">());
  listed.entry.name.assign(reinterpret_cast<const char*>(lines.data()) + kDirectoryHeaderBytes, nameSize);
  if (!take64(lines.subspan(kDirectoryHeaderBytes + nameSize, extraSize),
              {&listed.entry.size, &listed.packedSize, &listed.localHeader}))
    return bad(message<"zip-line-field">());
  lines = lines.subspan(size);
  return listed;
}

/// Returns true if the numbers of a file's local header, where given, equal those of the directory.
bool agrees(Fields header, const Listed& listed) {
  header.skip(6);
  const std::uint16_t flags = header.u16(), method = header.u16();
  header.skip(4);  // time and date
  const std::uint32_t crc = header.u32(), packedSize = header.u32(), size = header.u32();
  const auto same = [](std::uint32_t number, std::uint64_t expected) { return number == kSee64 || number == expected; };
  if (method != listed.entry.method) return false;
  return flags & kSizesFollow ||
         (crc == listed.entry.crc && same(packedSize, listed.packedSize) && same(size, listed.entry.size));
}

/// Finds the compressed bytes and checks that the local header describes the same file.
/// @param limit  start of the directory
Status findContent(std::span<const std::uint8_t> bytes, std::uint64_t limit, Listed& listed) {
  const auto bad = [&](Message what) { return damagedFile(listed.entry, std::move(what)); };
  const std::uint64_t at = listed.localHeader;
  if (at > limit || limit - at < kLocalHeaderBytes) return bad(message<"zip-file-misplaced">());
  Fields fields(bytes.subspan(static_cast<std::size_t>(at)));
  if (fields.u32() != kLocalSignature) return bad(message<"zip-file-not-there">());
  fields.skip(22);
  if (!agrees(Fields(bytes.subspan(static_cast<std::size_t>(at))), listed)) return bad(message<"zip-file-numbers">());
  const std::size_t nameSize = fields.u16(), extraSize = fields.u16();
  const std::uint64_t begin = at + kLocalHeaderBytes + nameSize + extraSize;
  if (begin > limit || limit - begin < listed.packedSize) return bad(message<"zip-file-too-long">());
  const std::span<const std::uint8_t> name = bytes.subspan(static_cast<std::size_t>(at) + kLocalHeaderBytes, nameSize);
  if (!std::equal(name.begin(), name.end(), listed.entry.name.begin(), listed.entry.name.end(),
                  [](std::uint8_t a, char b) { return a == static_cast<std::uint8_t>(b); }))
    return bad(message<"zip-file-name">());
  listed.entry.packed = bytes.subspan(static_cast<std::size_t>(begin), static_cast<std::size_t>(listed.packedSize));
  return {};
}

/// Refuses files that share bytes: overlapping files let small archives expand without end.
Status checkOverlap(std::span<const std::uint8_t> bytes, std::vector<Listed>& files) {
  std::sort(files.begin(), files.end(), [](const Listed& a, const Listed& b) { return a.localHeader < b.localHeader; });
  for (std::size_t i = 1; i < files.size(); ++i) {
    const std::span<const std::uint8_t> before = files[i - 1].entry.packed;
    if (static_cast<std::uint64_t>(before.data() - bytes.data()) + before.size() > files[i].localHeader)
      return damaged(message<"zip-files-overlap">(with::quoted<"first">(excerpt(files[i - 1].entry.name)),
                                                  with::quoted<"second">(excerpt(files[i].entry.name))));
  }
  return {};
}

int hexValue(char c) {
  return c >= '0' && c <= '9'   ? c - '0'
         : c >= 'a' && c <= 'f' ? c - 'a' + 10
         : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                : -1;
}

std::string comparable(std::string_view name) {
  std::string result;
  for (std::size_t i = 0; i < name.size(); ++i) {
    char c = name[i];
    if (c == '%' && i + 2 < name.size() && hexValue(name[i + 1]) >= 0 && hexValue(name[i + 2]) >= 0) {
      c = static_cast<char>(16 * hexValue(name[i + 1]) + hexValue(name[i + 2]));
      i += 2;
    }
    if (c == '\\') c = '/';  // some programs of Windows write backslashes
    result += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return result;
}

}  // namespace

Result<ZipArchive> ZipArchive::open(std::span<const std::uint8_t> bytes) {
  const Result<Directory> directory = findDirectory(bytes);
  QRELIEF_TRY(directory);
  std::span<const std::uint8_t> lines =
      bytes.subspan(static_cast<std::size_t>(directory->offset), static_cast<std::size_t>(directory->size));
  std::vector<Listed> files;
  for (std::uint64_t i = 0; i < directory->entries; ++i) {
    Result<Listed> listed = readListed(lines, i);
    QRELIEF_TRY(listed);
    QRELIEF_TRY(findContent(bytes, directory->offset, *listed));
    files.push_back(std::move(*listed));
  }
  QRELIEF_TRY(checkOverlap(bytes, files));

  ZipArchive archive;
  archive.trailingBytes_ = directory->trailingBytes;
  for (Listed& file : files) {
    if (file.entry.name.ends_with('/')) continue;  // a folder
    const std::string name = excerpt(file.entry.name);
    const std::string key = comparable(file.entry.name);
    archive.order_.push_back(key);
    if (!archive.entries_.emplace(key, std::move(file.entry)).second)
      return damaged(message<"zip-same-name">(with::quoted<"file">(name)));
  }
  return archive;
}

const ZipEntry* ZipArchive::find(std::string_view name) const {
  const auto it = entries_.find(comparable(name));
  return it == entries_.end() ? nullptr : &it->second;
}

std::vector<const ZipEntry*> ZipArchive::files() const {
  std::vector<const ZipEntry*> files;
  for (const std::string& key : order_) files.push_back(&entries_.at(key));
  return files;
}

struct ZipStream::State {
  const ZipEntry* entry = nullptr;
  z_stream z{};
  bool inflating = false;
  bool ended = false;
  std::uint64_t given = 0;  // bytes handed out so far
  std::uint32_t crc = 0;
  std::array<std::vector<std::uint8_t>, 2> pieces;  // the last one given, and the one before

  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State() {
    if (inflating) inflateEnd(&z);
  }

  tl::unexpected<Error> bad(Message what) const { return damagedFile(*entry, std::move(what)); }

  std::span<const std::uint8_t> nextStored() {
    const auto from = static_cast<std::size_t>(given);
    return entry->packed.subspan(from, std::min(kPieceBytes, entry->packed.size() - from));
  }

  Result<std::span<const std::uint8_t>> nextInflated() {
    std::vector<std::uint8_t>& piece = pieces[0];
    piece.swap(pieces[1]);
    constexpr std::uint64_t kOneTooMany = 1;  // shows that the announced size is wrong
    piece.resize(static_cast<std::size_t>(std::min<std::uint64_t>(kPieceBytes, entry->size + kOneTooMany)));
    z.next_out = piece.data();
    z.avail_out = static_cast<uInt>(piece.size());
    while (z.avail_out == piece.size() && !ended) {
      const int status = inflate(&z, Z_NO_FLUSH);
      if (status == Z_MEM_ERROR) throw std::bad_alloc();
      if (status == Z_STREAM_END)
        ended = true;
      else if (status != Z_OK)
        return bad(message<"zip-file-unpacking">());
    }
    return std::span<const std::uint8_t>(piece.data(), piece.size() - z.avail_out);
  }

  Status checkEnd() const {
    if (given != entry->size)
      return bad(message<"zip-file-size">(with::count<"count">(given), with::count<"announced">(entry->size)));
    if (inflating && z.avail_in > 0) return bad(message<"zip-file-followed">());
    if (crc != entry->crc) return bad(message<"zip-file-checksum">());
    return {};
  }
};

ZipStream::ZipStream(std::unique_ptr<State> state) : state_(std::move(state)) {}
ZipStream::ZipStream(ZipStream&&) noexcept = default;
ZipStream& ZipStream::operator=(ZipStream&&) noexcept = default;
ZipStream::~ZipStream() = default;

Result<ZipStream> ZipStream::open(const ZipEntry& entry, std::uint64_t maxBytes) {
  if (entry.flags & kEncrypted) return badInput(message<"zip-encrypted">(with::quoted<"file">(excerpt(entry.name))));
  if (entry.method != kStored && entry.method != kDeflated)
    return badInput(
        message<"zip-method">(with::quoted<"file">(excerpt(entry.name)), with::index<"method">(entry.method)));
  if (entry.size > maxBytes || (entry.size > kFreeBytes && entry.size / kMaxRatio > entry.packed.size()))
    return badInput(message<"zip-expands">(with::quoted<"file">(excerpt(entry.name)),
                                           with::count<"packed">(entry.packed.size()), with::count<"bytes">(entry.size),
                                           with::count<"limit">(maxBytes), with::count<"ratio">(kMaxRatio)));
  auto state = std::make_unique<State>();
  state->entry = &entry;
  if (entry.method == kStored && entry.size != entry.packed.size()) return state->bad(message<"zip-file-two-sizes">());
  if (entry.method == kDeflated) {
    state->z.next_in = const_cast<Bytef*>(entry.packed.data());
    state->z.avail_in = static_cast<uInt>(entry.packed.size());
    if (inflateInit2(&state->z, -MAX_WBITS) != Z_OK) throw std::bad_alloc();
    state->inflating = true;
  }
  return ZipStream(std::move(state));
}

Result<std::span<const std::uint8_t>> ZipStream::next() {
  State& s = *state_;
  const Result<std::span<const std::uint8_t>> piece =
      s.inflating ? s.nextInflated() : Result<std::span<const std::uint8_t>>(s.nextStored());
  if (!piece) return piece;
  s.given += piece->size();
  if (s.given > s.entry->size) return s.bad(message<"zip-file-more">());
  s.crc = static_cast<std::uint32_t>(crc32_z(s.crc, piece->data(), piece->size()));
  if (piece->empty()) QRELIEF_TRY(s.checkEnd());
  return piece;
}

Result<std::vector<std::uint8_t>> unpacked(const ZipEntry& entry, std::uint64_t maxBytes) {
  auto stream = ZipStream::open(entry, maxBytes);
  QRELIEF_TRY(stream);
  std::vector<std::uint8_t> content;
  for (;;) {
    const auto piece = stream->next();
    QRELIEF_TRY(piece);
    if (piece->empty()) return content;
    content.insert(content.end(), piece->begin(), piece->end());
  }
}

}  // namespace qrelief
