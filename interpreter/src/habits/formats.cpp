#include "habits/formats.hpp"

#include <cstddef>

#include "habits/pieces.hpp"

namespace armlet::lang {
namespace {

std::string trimmed(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return std::string(text);
}

bool is_quoted(std::string_view text) {
  return text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
         text.back() == text.front();
}

// The part of a conversion between its % and its letter, as a format has it: -8.2 is <8.2.
std::string style_of(std::string_view written, char letter) {
  std::string style;
  if (written.starts_with('-')) {
    style = "<";
    written.remove_prefix(1);
  }
  style += written;
  const bool is_decimal = letter == 'f' || letter == 'e' || letter == 'g';
  if (letter == 'f' && written.find('.') == std::string_view::npos) style += ".6";
  if (is_decimal) style += letter;
  return style;
}

// A value inside a formatted text.
std::string in_braces(std::string value, const std::string& style) {
  if (value.find('?') != std::string::npos) value = '(' + value + ')';
  for (char& c : value) {
    if (c == '"') c = '\'';
  }
  return '{' + value + (style.empty() ? "" : ':' + style) + '}';
}

}  // namespace

std::vector<std::string> values_of(std::string_view text) {
  const Line line(text);
  std::vector<std::string> out;
  int depth = 0;
  std::size_t first = 0;
  for (std::size_t i = 0; i <= line.pieces.size(); ++i) {
    const std::string_view piece = i < line.pieces.size() ? line.piece(i) : ",";
    if (piece == "(" || piece == "[" || piece == "{") ++depth;
    if (piece == ")" || piece == "]" || piece == "}") --depth;
    if (piece != "," || depth > 0) continue;
    if (i > first) out.push_back(trimmed(line.text_of(first, i)));
    first = i + 1;
  }
  return out;
}

std::optional<std::string> formatted_text(const std::vector<std::string>& values, bool is_line) {
  if (values.empty() || !is_quoted(values[0])) return std::nullopt;
  std::string_view text = std::string_view(values[0]).substr(1, values[0].size() - 2);
  if (is_line && text.ends_with("\\n")) text.remove_suffix(2);
  std::string out;
  std::size_t used = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    if (text[at] == '{' || text[at] == '}') out += text[at];
    if (text[at] != '%') {
      out += text[at];
      continue;
    }
    std::size_t letter = text.find_first_not_of("-+0123456789.lh", at + 1);
    if (letter == std::string_view::npos) return std::nullopt;
    std::string_view written = text.substr(at + 1, letter - at - 1);
    while (written.ends_with('l') || written.ends_with('h')) written.remove_suffix(1);
    at = letter;
    if (text[letter] == '%' || text[letter] == 'n') {
      out += text[letter] == '%' ? "%" : is_line && letter + 1 == text.size() ? "" : "\\n";
      continue;
    }
    if (std::string_view("disbufegF").find(text[letter]) == std::string_view::npos ||
        ++used >= values.size())
      return std::nullopt;
    out += in_braces(values[used], style_of(written, text[letter]));
  }
  if (used + 1 != values.size()) return std::nullopt;
  return used == 0 ? '"' + out + '"' : "f\"" + out + '"';
}

std::optional<std::string> text_with_braces(const std::vector<std::string>& values) {
  if (values.empty() || !is_quoted(values[0])) return std::nullopt;
  const std::string_view text = std::string_view(values[0]).substr(1, values[0].size() - 2);
  std::string out = "f\"";
  std::size_t used = 0;
  for (std::size_t at = 0; at < text.size(); ++at) {
    out += text[at];
    if (text[at] != '{') continue;
    const bool is_place = at + 1 < text.size() && (text[at + 1] == '}' || text[at + 1] == ':');
    if (!is_place || ++used >= values.size()) return std::nullopt;
    const std::string value = in_braces(values[used], "");
    out += value.substr(1, value.size() - 2);
  }
  if (used + 1 != values.size()) return std::nullopt;
  return out + '"';
}

}  // namespace armlet::lang
