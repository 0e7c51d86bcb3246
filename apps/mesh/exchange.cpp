#include "exchange.hpp"

#include <algorithm>
#include <array>

namespace armlet::mesh {

std::string say_header(Say what, std::size_t length) {
  std::string header(1, static_cast<char>(what));
  for (int k = 0; k < 4; ++k) header += static_cast<char>((length >> (8 * k)) & 0xffU);
  return header;
}

std::size_t said_length(const char* header) {
  std::size_t length = 0;
  for (std::size_t k = 4; k-- > 0;)
    length = length << 8 | static_cast<unsigned char>(header[1 + k]);
  return length;
}

std::string_view mesh_format(std::string_view name) {
  constexpr std::array<std::string_view, 8> kEndings = {"obj", "3ds", "wrl",  "stl",
                                                        "dae", "ply", "gltf", "glb"};
  const std::size_t dot = name.rfind('.');
  if (dot == std::string_view::npos) return {};
  const std::string_view ending = name.substr(dot + 1);
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  for (const std::string_view each : kEndings) {
    if (std::equal(ending.begin(), ending.end(), each.begin(), each.end(),
                   [&](char a, char b) { return lower(a) == b; }))
      return each;
  }
  return {};
}

}  // namespace armlet::mesh
