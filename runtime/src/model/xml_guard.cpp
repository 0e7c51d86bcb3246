#include "xml_guard.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace armlet {
namespace {

constexpr std::size_t kMaxBytes = 16 << 20;
constexpr int kMaxDepth = 100;

}  // namespace

std::size_t after_xml(std::string_view text, std::size_t at, std::string_view last) {
  const std::size_t found = text.find(last, at);
  return found == std::string_view::npos ? text.size() : found + last.size();
}

std::size_t after_xml_tag(std::string_view text, std::size_t at) {
  char quote = 0;
  for (; at < text.size(); ++at) {
    const char c = text[at];
    if (quote != 0) {
      if (c == quote) quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '>') {
      return at + 1;
    }
  }
  return at;
}

std::string xml_fault(std::string_view text) {
  if (text.size() > kMaxBytes) {
    return fmt::format("the file has {} bytes; at most {} are read", text.size(), kMaxBytes);
  }
  if (text.find_first_not_of(" \t\r\n") == std::string_view::npos) return "the file is empty";
  if (text.find('\0') != std::string_view::npos)
    return "the file holds a zero byte, so it is no text";
  int depth = 0;
  for (std::size_t at = text.find('<'); at < text.size(); at = text.find('<', at)) {
    const std::string_view rest = text.substr(at);
    if (rest.starts_with("<!--")) {
      at = after_xml(text, at, "-->");
    } else if (rest.starts_with("<![CDATA[")) {
      at = after_xml(text, at, "]]>");
    } else if (rest.starts_with("<!")) {
      return "the file declares its own document type; a robot description needs none";
    } else if (rest.starts_with("</") || rest.starts_with("<?")) {
      depth -= rest.starts_with("</") ? 1 : 0;
      at += 2;
    } else {
      const std::size_t end = after_xml_tag(text, at);
      if (!text.substr(at, end - at).ends_with("/>")) ++depth;
      if (depth > kMaxDepth) {
        return fmt::format(
            "its elements are nested more than {} deep (line {})", kMaxDepth,
            1 + std::count(text.begin(), text.begin() + static_cast<long>(at), '\n'));
      }
      // Not past the tag: what looks like quoted text to us may look like tags to a parser.
      at += 1;
    }
  }
  return {};
}

}  // namespace armlet
