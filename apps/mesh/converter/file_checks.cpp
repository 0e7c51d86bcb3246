#include "converter/file_checks.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "armlet/core/error.hpp"

namespace armlet::mesh {
namespace {

constexpr int kDeepest = 64;

[[noreturn]] void refuse(const std::string& why) { throw ArgumentError(why); }

// DAE: no declarations of its own, and elements in one another that a recursion can follow.
void check_xml(std::string_view text) {
  if (text.find("<!DOCTYPE") != std::string_view::npos ||
      text.find("<!ENTITY") != std::string_view::npos)
    refuse("it declares entities, which are not read");
  if (text.find("XInclude") != std::string_view::npos ||
      text.find("<xi:include") != std::string_view::npos)
    refuse("it includes another file, which is not read");
  int depth = 0;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("<!--")) {
      at = std::min(text.find("-->", at), text.size() - 1);
      continue;
    }
    if (rest.starts_with("</")) {
      --depth;
      continue;
    }
    if (rest.starts_with("<?") || rest.starts_with("<!")) continue;
    const std::size_t end = text.find('>', at);
    if (end == std::string_view::npos) refuse("it is cut off in an element");
    if (text[end - 1] != '/') ++depth;
    if (depth > kDeepest) refuse(fmt::format("it has more than {} elements in one another", kDeepest));
  }
}

std::size_t little_endian(std::string_view bytes, std::size_t at) {
  std::size_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

// 3DS: chunks, each with the length of what is in it.
void check_3ds(std::string_view bytes) {
  if (bytes.size() < 6 || bytes[0] != 0x4d || bytes[1] != 0x4d)
    refuse("it is no 3DS file: it does not begin with its main chunk");
  if (little_endian(bytes, 2) > bytes.size()) {
    refuse(fmt::format("its main chunk says {} bytes, but the file has {}", little_endian(bytes, 2),
                       bytes.size()));
  }
}

// STL in binary form: 80 bytes, the number of triangles, 50 bytes for each.
void check_stl(std::string_view bytes) {
  constexpr std::size_t kHeader = 84, kTriangle = 50;
  const bool is_text = bytes.starts_with("solid") &&
                       bytes.substr(0, 1024).find("facet") != std::string_view::npos;
  if (is_text) {
    if (bytes.find("endsolid") == std::string_view::npos) refuse("it is cut off: `endsolid` is missing");
    return;
  }
  if (bytes.size() < kHeader) refuse(fmt::format("it is cut off: it has {} bytes", bytes.size()));
  const std::size_t count = little_endian(bytes, 80);
  if (count * kTriangle > bytes.size() - kHeader) {
    refuse(fmt::format("its header says {} triangles, but there are bytes for {}", count,
                       (bytes.size() - kHeader) / kTriangle));
  }
}

// PLY: as many elements as the header says need at least a byte each.
void check_ply(std::string_view bytes) {
  const std::size_t end = bytes.find("end_header");
  if (!bytes.starts_with("ply") || end == std::string_view::npos)
    refuse("it is no PLY file: its header does not begin with `ply` and end with `end_header`");
  std::string_view header = bytes.substr(0, end);
  std::size_t elements = 0;
  for (std::size_t at = header.find("element"); at != std::string_view::npos;
       at = header.find("element", at + 1)) {
    const std::string_view line = header.substr(at, header.find('\n', at) - at);
    const std::size_t digits = line.find_first_of("0123456789", line.find_last_of(" \t"));
    std::size_t count = 0;
    for (std::size_t k = std::min(digits, line.size()); k < line.size() && line[k] >= '0' && line[k] <= '9'; ++k)
      count = std::min<std::size_t>(count * 10 + static_cast<std::size_t>(line[k] - '0'), 1ULL << 40);
    elements += count;
  }
  if (elements > bytes.size() - end) {
    refuse(fmt::format("its header says {} elements, but {} bytes follow it", elements,
                       bytes.size() - end));
  }
}

}  // namespace

void check_lines(std::string_view text, std::string_view name) {
  if (text.find('\0') != std::string_view::npos)
    refuse(fmt::format("\"{}\" is no text: it has a byte of 0", name));
}

void check_before_assimp(const Input& input) {
  const std::string_view bytes = input.bytes;
  if (input.format == "obj") check_lines(bytes, input.name);
  if (input.format == "dae") {
    if (bytes.starts_with("PK")) refuse("it is a packed archive; unpack it first");
    check_lines(bytes, input.name);
    check_xml(bytes);
  }
  if (input.format == "3ds") check_3ds(bytes);
  if (input.format == "stl") check_stl(bytes);
  if (input.format == "ply") check_ply(bytes);
}

}  // namespace armlet::mesh
