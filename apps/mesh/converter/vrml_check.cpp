// Words of VRML 2.0, looked at before Coin reads the file: Coin opens what `Inline` names while it
// parses, and calls itself for each brace.

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "armlet/core/error.hpp"
#include "converter/importers.hpp"

namespace armlet::mesh {
namespace {

constexpr int kDeepest = 200;

[[noreturn]] void refuse(const std::string& why) { throw ArgumentError(why); }

// What reads other files or runs programs, also by the names that Coin knows besides.
constexpr std::array<std::string_view, 11> kRefused = {
    "Inline",    "EXTERNPROTO", "Script", "File",       "WWWInline",   "InlineLOD",
    "MovieTexture", "AudioClip", "SoFile", "VRMLInline", "VRMLScript"};

bool ends_word(char c) {
  return c <= ' ' || c == ',' || c == '{' || c == '}' || c == '[' || c == ']' || c == '"' || c == '#';
}

int line_of(std::string_view text, std::size_t at) {
  return 1 + static_cast<int>(std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

void check_header(std::string_view text) {
  if (text.starts_with("\x1f\x8b")) refuse("it is compressed; unpack it with gunzip");
  const std::string_view first = text.substr(0, std::min(text.find_first_of("\r\n"), text.size()));
  if (first.starts_with("#VRML V1.0")) refuse("it is VRML 1.0; expected 2.0 (#VRML V2.0 utf8)");
  if (!first.starts_with("#VRML V2.0 utf8")) refuse("its first line is not #VRML V2.0 utf8");
}

// Behind the end of a text in quotes.
std::size_t skip_quoted(std::string_view text, std::size_t at) {
  for (std::size_t k = at + 1; k < text.size(); ++k) {
    if (text[k] == '\\') {
      ++k;
    } else if (text[k] == '"') {
      return k + 1;
    }
  }
  refuse(fmt::format("line {}: a text in quotes does not end", line_of(text, at)));
}

// Behind the end of the word at `at`.
std::size_t skip_word(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && !ends_word(text[end])) ++end;
  const std::string_view word = text.substr(at, end - at);
  if (std::find(kRefused.begin(), kRefused.end(), word) != kRefused.end()) {
    refuse(fmt::format("line {}: `{}` would open another file or run a script, which is not done",
                       line_of(text, at), word));
  }
  return end;
}

// Opens and closes what is counted by `depth`.
void follow_bracket(std::string_view text, std::size_t at, int& depth) {
  depth += text[at] == '{' || text[at] == '[' ? 1 : -1;
  if (depth > kDeepest) {
    refuse(fmt::format("line {}: more than {} nodes in one another", line_of(text, at), kDeepest));
  }
  if (depth < 0)
    refuse(fmt::format("line {}: {} closes what was not opened", line_of(text, at), text[at]));
}

}  // namespace

std::string safe_vrml(std::string_view text) {
  check_header(text);
  if (text.find('\0') != std::string_view::npos) refuse("it is no text: it has a byte of 0");
  std::string safe;
  safe.reserve(text.size());
  int depth = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    std::size_t end = at + 1;
    if (c == '#') {
      end = std::min(text.find_first_of("\r\n", at), text.size());
    } else if (c == '"') {
      end = skip_quoted(text, at);
    } else if (c == '{' || c == '}' || c == '[' || c == ']') {
      follow_bracket(text, at, depth);
    } else if (!ends_word(c)) {
      end = skip_word(text, at);
    }
    const std::string_view part = text.substr(at, end - at);
    safe += part == "ImageTexture" ? std::string_view("MovieTexture") : part;
    at = end;
  }
  if (depth > 0) refuse(fmt::format("it is cut off: {} brackets are not closed", depth));
  return safe;
}

}  // namespace armlet::mesh
