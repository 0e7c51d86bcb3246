// The parts of a GLB file: a header, a description, a binary part, and notes.

#include <algorithm>
#include <array>
#include <limits>

#include "armlet/core/error.hpp"
#include "armlet/mesh/glb.hpp"
#include "mesh/glb_format.hpp"

namespace armlet {
namespace {

void append_number(std::string& bytes, std::uint32_t value) {
  for (int k = 0; k < 4; ++k) bytes += static_cast<char>((value >> (8 * k)) & 0xffU);
}

std::uint32_t number_at(std::string_view bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

void fill_up(std::string& bytes, char with) {
  while (bytes.size() % 4 != 0) bytes += with;
}

void append_chunk(std::string& bytes, std::uint32_t kind, const std::string& content) {
  append_number(bytes, static_cast<std::uint32_t>(content.size()));
  append_number(bytes, kind);
  bytes += content;
}

}  // namespace

std::string make_glb(std::string json, std::string binary, const std::vector<std::string>& notes) {
  std::string text;
  for (const std::string& each : notes) text += each + '\n';
  fill_up(json, ' ');
  fill_up(binary, '\0');
  fill_up(text, '\n');
  const auto space = [](const std::string& chunk) { return chunk.empty() ? 0 : 8 + chunk.size(); };
  const std::size_t length = 12 + space(json) + space(binary) + space(text);
  if (length > std::numeric_limits<std::uint32_t>::max())
    throw ArgumentError("The scene would be a file of more than 4 GB.");
  std::string bytes;
  bytes.reserve(length);
  append_number(bytes, glb::kMagic);
  append_number(bytes, 2);
  append_number(bytes, static_cast<std::uint32_t>(length));
  append_chunk(bytes, glb::kJsonChunk, json);
  if (!binary.empty()) append_chunk(bytes, glb::kBinaryChunk, binary);
  if (!text.empty()) append_chunk(bytes, glb::kNotesChunk, text);
  return bytes;
}

std::vector<std::string> glb_notes(std::string_view bytes) {
  std::vector<std::string> notes;
  if (bytes.size() < 12 || number_at(bytes, 0) != glb::kMagic) return notes;
  for (std::size_t at = 12; bytes.size() - at >= 8;) {
    const std::size_t length = number_at(bytes, at);
    const std::uint32_t kind = number_at(bytes, at + 4);
    if (length > bytes.size() - at - 8) break;
    std::string_view text = bytes.substr(at + 8, length);
    while (kind == glb::kNotesChunk && !text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      if (end > 0) notes.emplace_back(text.substr(0, end));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    at += 8 + length;
  }
  return notes;
}

int json_depth(std::string_view text) {
  int depth = 0, deepest = 0;
  bool quoted = false;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const char c = text[k];
    if (quoted && c == '\\') {
      ++k;
    } else if (c == '"') {
      quoted = !quoted;
    } else if (!quoted && (c == '{' || c == '[')) {
      deepest = std::max(deepest, ++depth);
    } else if (!quoted && (c == '}' || c == ']')) {
      --depth;
    }
  }
  return deepest;
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

bool is_glb_name(std::string_view name) { return mesh_format(name) == "glb"; }

}  // namespace armlet
