#include "converter/file_checks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "converter/refuse.hpp"

namespace armlet::mesh {
namespace {

// OBJ: corners of faces refer to positions, texture coordinates and normals in earlier lines, by
// index from 1 on, or from -1 backwards. Assimp ignores missing ones of the last two kinds.
class ObjCheck {
 public:
  void look(std::string_view line) {
    while (!line.empty() && is_blank(line.front())) line.remove_prefix(1);
    if (line.starts_with("v ") || line.starts_with("v\t")) ++counts_[0];
    if (line.starts_with("vt")) ++counts_[1];
    if (line.starts_with("vn")) ++counts_[2];
    if (line.starts_with("f ") || line.starts_with("f\t")) look_at_face(line.substr(2));
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

  void look_at_face(std::string_view corners) const {
    std::size_t kind = 0;
    for (std::size_t at = 0; at < corners.size();) {
      const char c = corners[at];
      if (is_blank(c)) kind = 0;
      if (c == '/') ++kind;
      if (c != '-' && (c < '0' || c > '9')) {
        ++at;
        continue;
      }
      const std::size_t begin = at++;
      while (at < corners.size() && corners[at] >= '0' && corners[at] <= '9') ++at;
      check(corners.substr(begin, at - begin), kind);
    }
  }

  void check(std::string_view digits, std::size_t kind) const {
    constexpr std::array<std::string_view, 3> kWhat = {"v", "vt", "vn"};
    std::size_t value = 0;
    for (const char c : digits) {
      if (c != '-')
        value = std::min<std::size_t>(value * 10 + static_cast<std::size_t>(c - '0'), 1ULL << 40);
    }
    if (kind < kWhat.size() && (value == 0 || value > counts_[kind])) {
      refuse(fmt::format("a face names {} {}, but there are {} above it", kWhat[kind],
                         digits.substr(0, 20), counts_[kind]));
    }
  }

  std::array<std::size_t, 3> counts_{};
};

void check_obj(std::string_view text) {
  ObjCheck check;
  std::string joined;  // of lines that are continued by a \ at the end
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view line = text.substr(at, end - at);
    at = end + 1;
    if (line.ends_with('\r')) line.remove_suffix(1);
    if (line.ends_with('\\')) {
      joined += line.substr(0, line.size() - 1);
      joined += ' ';
      continue;
    }
    if (joined.empty()) {
      check.look(line);
    } else {
      check.look(joined += line);
      joined.clear();
    }
  }
}

std::size_t little_endian(std::string_view bytes, std::size_t at) {
  std::size_t value = 0;
  for (std::size_t k = 4; k-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes[at + k]);
  return value;
}

// 3DS: chunks, each with the length of its contents.
void check_3ds(std::string_view bytes) {
  if (bytes.size() < 6 || bytes[0] != 0x4d || bytes[1] != 0x4d)
    refuse("it is no 3DS file: it does not begin with its main chunk");
  if (little_endian(bytes, 2) > bytes.size()) {
    refuse(fmt::format("its main chunk says {} bytes, but the file has {}", little_endian(bytes, 2),
                       bytes.size()));
  }
}

}  // namespace

void check_lines(std::string_view text, std::string_view name) {
  if (text.find('\0') != std::string_view::npos)
    refuse(fmt::format("\"{}\" is no text: it has a byte of 0", name));
}

void check_before_assimp(const Input& input) {
  const std::string_view bytes = input.bytes;
  if (input.format == "obj") {
    check_lines(bytes, input.name);
    check_obj(bytes);
  }
  if (input.format == "dae") {
    if (bytes.starts_with("PK")) refuse("it is a packed archive; unpack it first");
    check_lines(bytes, input.name);
    check_dae(bytes);
  }
  if (input.format == "3ds") check_3ds(bytes);
  if (input.format == "ply") check_ply(bytes);
}

}  // namespace armlet::mesh
