// SPDX-License-Identifier: GPL-3.0-or-later
// Writes texts as symbols in several character sets, for decoders to read (bench/character_sets.mjs).
//   qrelief_character_sets FOLDER
// Prints one JSON object a line: text, way, version, picture, and what ZXing-C++ reads.
#include <ZXing/ReadBarcode.h>
#include <fmt/format.h>
#include <fstream>
#include <iconv.h>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <qrencode.h>
#include <string>
#include <string_view>

#include "qr/symbol.h"

namespace {

constexpr const char* kTexts[] = {
    "https://example.com/a1",
    "Zürich",
    "Müller & Söhne",
    "Größe: 12 µm",
    "Température: 21 °C",
    "Où êtes-vous, Zoë ?",
    "Œuvre n° 5",
    "El niño, mañana",
    "Łódź, ulica Żółta 7",
    "Příliš žluťoučký kůň",
    "Καλημέρα κόσμε",
    "Привет, мир",
    "東京都千代田区",
    "こんにちは",
    "ﾃｽﾄ 品番12",
    "你好，世界",
    "안녕하세요",
    "שלום",
    "Preis: 12 €",
    "„Grüße“ – 5 ½″",
    "Hello 👋🏽",
    "https://example.com/straße?q=ü",
    "BEGIN:VCARD\r\nVERSION:3.0\r\nN:Müller;Jörg;;;\r\nFN:Jörg Müller\r\nADR:;;Zürichstraße "
    "5;Köln;;50667;\r\nEND:VCARD",
    "WIFI:T:WPA;S:Café \\; Bar;P:a\\\\b;;",
};

struct Way {
  const char* name;
  int eci;              ///< 0: none
  const char* charset;  ///< of the bytes; null: as QRelief writes texts
  const char* before;   ///< bytes before the text
};
constexpr Way kWays[] = {{"UTF-8", 0, "UTF-8", ""},
                         {"UTF-8, ECI 26", 26, "UTF-8", ""},
                         {"UTF-8, byte order mark", 0, "UTF-8", "\xEF\xBB\xBF"},
                         {"Latin-1", 0, "ISO-8859-1", ""},
                         {"Latin-1, ECI 3", 3, "ISO-8859-1", ""},
                         {"Kanji mode", 0, "SHIFT_JIS", ""},
                         {"QRelief", 0, nullptr, ""}};

std::optional<std::string> converted(std::string text, const char* charset) {
  const iconv_t to = iconv_open(charset, "UTF-8");
  std::string bytes(4 * text.size(), '\0');
  char *in = text.data(), *out = bytes.data();
  std::size_t left = text.size(), room = bytes.size();
  const bool fits = iconv(to, &in, &left, &out, &room) != static_cast<std::size_t>(-1);
  iconv_close(to);
  bytes.resize(bytes.size() - room);
  return fits ? std::optional(bytes) : std::nullopt;
}

struct Modules {
  int size = 0;
  int version = 0;
  std::string dark;  ///< '\1' = dark, row by row
};

std::optional<Modules> encoded(const char* text, const Way& way) {
  if (!way.charset) {
    const auto symbol = qrelief::encodeSymbol(text);
    if (!symbol) return std::nullopt;
    return Modules{symbol->size, symbol->version, std::string(symbol->dark.begin(), symbol->dark.end())};
  }
  const auto bytes = converted(text, way.charset);
  if (!bytes) return std::nullopt;
  const std::string whole = way.before + *bytes;
  const std::unique_ptr<QRinput, decltype(&QRinput_free)> input(QRinput_new2(0, QR_ECLEVEL_M), &QRinput_free);
  const bool isKanji = std::string_view(way.charset) == "SHIFT_JIS";
  if (way.eci != 0) QRinput_appendECIheader(input.get(), static_cast<unsigned>(way.eci));
  if (QRinput_append(input.get(), isKanji ? QR_MODE_KANJI : QR_MODE_8, static_cast<int>(whole.size()),
                     reinterpret_cast<const unsigned char*>(whole.data())) != 0)
    return std::nullopt;
  const std::unique_ptr<QRcode, decltype(&QRcode_free)> code(QRcode_encodeInput(input.get()), &QRcode_free);
  if (!code) return std::nullopt;
  Modules modules{code->width, code->version, {}};
  for (int i = 0; i < code->width * code->width; ++i) modules.dark += static_cast<char>(code->data[i] & 1);
  return modules;
}

struct Picture {
  int size = 0;  ///< pixels
  std::string pixels;
};

Picture drawn(const Modules& code, int pixelsPerModule) {
  constexpr int kQuiet = 4;
  const int size = (code.size + 2 * kQuiet) * pixelsPerModule;
  Picture picture{size, std::string(static_cast<std::size_t>(size * size), '\xFF')};
  const int begin = kQuiet * pixelsPerModule;
  for (int y = 0; y < code.size * pixelsPerModule; ++y)
    for (int x = 0; x < code.size * pixelsPerModule; ++x)
      if (code.dark[static_cast<std::size_t>(y / pixelsPerModule * code.size + x / pixelsPerModule)] != 0)
        picture.pixels[static_cast<std::size_t>((y + begin) * size + x + begin)] = '\0';
  return picture;
}

std::string readWithZxing(const Picture& picture) {
  const ZXing::ImageView view(reinterpret_cast<const std::uint8_t*>(picture.pixels.data()), picture.size, picture.size,
                              ZXing::ImageFormat::Lum);
  ZXing::DecodeHints hints;
  hints.setFormats(ZXing::BarcodeFormat::QRCode);
  const ZXing::Result read = ZXing::ReadBarcode(view, hints);
  return read.isValid() ? read.text() : "";
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) return 2;
  int number = 0;
  for (const char* text : kTexts)
    for (const Way& way : kWays) {
      const auto code = encoded(text, way);
      if (!code) continue;
      nlohmann::json files = nlohmann::json::array(), reads = nlohmann::json::array();
      for (const int pixelsPerModule : {6, 8, 5}) {
        const Picture picture = drawn(*code, pixelsPerModule);
        files.push_back(fmt::format("{}/{:03}-{}.pgm", argv[1], number, pixelsPerModule));
        std::ofstream(files.back().get<std::string>(), std::ios::binary)
            << fmt::format("P5\n{0} {0}\n255\n", picture.size) << picture.pixels;
        reads.push_back(readWithZxing(picture));
      }
      ++number;
      const nlohmann::json line = {
          {"text", text}, {"way", way.name}, {"version", code->version}, {"files", files}, {"zxing", reads}};
      fmt::print("{}\n", line.dump());
    }
}
