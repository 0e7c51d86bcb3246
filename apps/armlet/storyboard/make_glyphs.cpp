// Writes glyphs.inc, the letters of pictures, from the font of the package fonts-dejavu-core:
// make_glyphs /usr/share/fonts/truetype/dejavu/DejaVuSans.ttf >glyphs.inc

#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>

int main(int count, char** words) {
  if (count != 2) {
    std::fputs("usage: make_glyphs DejaVuSans.ttf >glyphs.inc\n", stderr);
    return 2;
  }
  std::ifstream file(words[1], std::ios::binary);
  const std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(file), {}};
  stbtt_fontinfo font;
  if (bytes.empty() || stbtt_InitFont(&font, bytes.data(), 0) == 0) {
    std::fprintf(stderr, "make_glyphs: %s is no font\n", words[1]);
    return 1;
  }
  constexpr int kHeight = 22;
  const float scale = stbtt_ScaleForPixelHeight(&font, kHeight);
  int ascent = 0;
  stbtt_GetFontVMetrics(&font, &ascent, nullptr, nullptr);
  const int baseline = static_cast<int>(std::lround(static_cast<float>(ascent) * scale));
  std::puts(
      "// Letters of Latin-1 from DejaVu Sans, made by make_glyphs.cpp: width, height, left and "
      "top of "
      "the ink,\n// how far the next one stands, and the ink row by row in sixteenths.");
  for (int code = 0x20; code <= 0xFF; ++code) {
    if (code >= 0x7F && code < 0xA0) continue;  // control characters
    int advance = 0, width = 0, height = 0, left = 0, top = 0;
    stbtt_GetCodepointHMetrics(&font, code, &advance, nullptr);
    unsigned char* ink =
        stbtt_GetCodepointBitmap(&font, scale, scale, code, &width, &height, &left, &top);
    std::string rows;
    for (int i = 0; i < width * height; ++i) rows += "0123456789abcdef"[ink[i] >> 4];
    stbtt_FreeBitmap(ink, nullptr);
    std::printf("{%d, %d, %d, %d, %d, \"%s\"},  // U+%04X\n", width, height, left, baseline + top,
                static_cast<int>(std::lround(static_cast<float>(advance) * scale)), rows.c_str(),
                code);
  }
}
