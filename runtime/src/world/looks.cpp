#include "armlet/world/looks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>

#include "armlet/core/similar.hpp"

namespace armlet {
namespace {

constexpr auto kColors = std::to_array<std::string_view>({
    "aliceblue", "antiquewhite", "aqua", "aquamarine", "azure", "beige", "bisque", "black",
    "blanchedalmond", "blue", "blueviolet", "brown", "burlywood", "cadetblue", "chartreuse",
    "chocolate", "coral", "cornflowerblue", "cornsilk", "crimson", "cyan", "darkblue", "darkcyan",
    "darkgoldenrod", "darkgray", "darkgreen", "darkgrey", "darkkhaki", "darkmagenta",
    "darkolivegreen", "darkorange", "darkorchid", "darkred", "darksalmon", "darkseagreen",
    "darkslateblue", "darkslategray", "darkslategrey", "darkturquoise", "darkviolet", "deeppink",
    "deepskyblue", "dimgray", "dimgrey", "dodgerblue", "firebrick", "floralwhite", "forestgreen",
    "fuchsia", "gainsboro", "ghostwhite", "gold", "goldenrod", "gray", "green", "greenyellow",
    "grey", "honeydew", "hotpink", "indianred", "indigo", "ivory", "khaki", "lavender",
    "lavenderblush", "lawngreen", "lemonchiffon", "lightblue", "lightcoral", "lightcyan",
    "lightgoldenrodyellow", "lightgray", "lightgreen", "lightgrey", "lightpink", "lightsalmon",
    "lightseagreen", "lightskyblue", "lightslategray", "lightslategrey", "lightsteelblue",
    "lightyellow", "lime", "limegreen", "linen", "magenta", "maroon", "mediumaquamarine",
    "mediumblue", "mediumorchid", "mediumpurple", "mediumseagreen", "mediumslateblue",
    "mediumspringgreen", "mediumturquoise", "mediumvioletred", "midnightblue", "mintcream",
    "mistyrose", "moccasin", "navajowhite", "navy", "oldlace", "olive", "olivedrab", "orange",
    "orangered", "orchid", "palegoldenrod", "palegreen", "paleturquoise", "palevioletred",
    "papayawhip", "peachpuff", "peru", "pink", "plum", "powderblue", "purple", "rebeccapurple",
    "red", "rosybrown", "royalblue", "saddlebrown", "salmon", "sandybrown", "seagreen",
    "seashell", "sienna", "silver", "skyblue", "slateblue", "slategray", "slategrey", "snow",
    "springgreen", "steelblue", "tan", "teal", "thistle", "tomato", "turquoise", "violet",
    "wheat", "white", "whitesmoke", "yellow", "yellowgreen",
});

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

std::uint32_t big_endian(std::string_view bytes, std::size_t at, int size) {
  std::uint32_t value = 0;
  for (int k = 0; k < size; ++k)
    value = value << 8 | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(k)]);
  return value;
}

std::string size_fault(std::uint32_t width, std::uint32_t height) {
  constexpr std::uint32_t kMost = 8192;
  if (width == 0 || height == 0) return "it has no pixels";
  if (width <= kMost && height <= kMost) return {};
  return fmt::format("it has {} x {} pixels; expected {} x {} at most", width, height, kMost, kMost);
}

std::string png_fault(std::string_view bytes) {
  if (bytes.size() < 33 || bytes.substr(12, 4) != "IHDR") return "it is cut off in its header";
  if (auto fault = size_fault(big_endian(bytes, 16, 4), big_endian(bytes, 20, 4)); !fault.empty())
    return fault;
  // The chunk that every one ends with.
  return bytes.substr(bytes.size() - 8, 4) == "IEND" ? std::string() : "it is cut off";
}

// Segments, each with its length, up to the one that has the size.
std::string jpeg_fault(std::string_view bytes) {
  for (std::size_t at = 2; at + 4 <= bytes.size();) {
    if (static_cast<unsigned char>(bytes[at]) != 0xff) break;
    const auto kind = static_cast<unsigned char>(bytes[at + 1]);
    if (kind == 0xff) {
      ++at;
      continue;
    }
    const std::uint32_t length = big_endian(bytes, at + 2, 2);
    const bool is_frame =
        kind >= 0xc0 && kind <= 0xcf && kind != 0xc4 && kind != 0xc8 && kind != 0xcc;
    if (is_frame) {
      if (at + 9 > bytes.size()) break;
      return size_fault(big_endian(bytes, at + 7, 2), big_endian(bytes, at + 5, 2));
    }
    if (length < 2 || kind == 0xda) break;
    at += 2 + length;
  }
  return "it is cut off before it says how large it is";
}

}  // namespace

bool is_color(std::string_view text) {
  if (text.size() == 7 && text[0] == '#') {
    return std::ranges::all_of(text.substr(1), [](char c) {
      return std::isxdigit(static_cast<unsigned char>(c)) != 0;
    });
  }
  std::string name(text);
  std::ranges::transform(name, name.begin(), lower);
  return std::ranges::find(kColors, std::string_view(name)) != kColors.end();
}

std::optional<std::string_view> similar_color(std::string_view text) {
  return most_similar(text, kColors);
}

std::string picture_fault(std::string_view bytes) {
  using namespace std::string_view_literals;
  if (bytes.starts_with("\x89PNG\r\n\x1a\n"sv)) return png_fault(bytes);
  if (bytes.starts_with("\xff\xd8\xff"sv)) return jpeg_fault(bytes);
  return "it is neither a PNG nor a JPEG picture";
}

}  // namespace armlet
