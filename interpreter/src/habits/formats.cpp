#include "habits/formats.hpp"

#include <cstddef>

#include "habits/meant.hpp"
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

// The style of a conversion, between % and its letter, as a format of this language: -8.2 becomes
// <8.2.
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

// A value in the braces of a formatted text.
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
  const bool ends_line = text.ends_with("\\n") || text.ends_with("%n");
  if (is_line && !ends_line) return std::nullopt;
  if (is_line) text.remove_suffix(2);
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
      out += text[letter] == '%' ? "%" : "\\n";
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

std::optional<std::string> streamed_text(const std::string& written, bool is_line) {
  const Line line(written);
  std::vector<std::string> values;
  std::size_t first = 0;
  for (std::size_t i = 0; i <= line.pieces.size(); ++i) {
    if (i < line.pieces.size() && line.piece(i) != "<<") continue;
    std::string value(line.text_of(first, i));
    first = i + 1;
    if (value.empty()) return std::nullopt;
    if (value == "std::endl" || value == "endl") value = "\"\\n\"";
    values.push_back(std::move(value));
  }
  if (is_line) {
    std::string& last = values.back();
    if (!is_quoted(last) || !last.ends_with("\\n\"")) return std::nullopt;
    last.erase(last.size() - 3, 2);
    if (last.size() == 2) values.pop_back();
  }
  if (values.empty()) return "\"\"";
  const bool is_text = is_quoted(values[0]);
  std::string out;
  for (const std::string& value : values)
    out += (out.empty() ? "" : " + ") + (values.size() == 1 ? value : as_factor(value));
  return values.size() > 1 && !is_text ? "\"\" + " + out : out;
}

std::optional<std::string> separated_text(const std::vector<std::string>& values) {
  if (values.size() < 2) return std::nullopt;
  std::string out;
  for (std::size_t i = 0; i + 1 < values.size(); ++i) {
    if (i > 0) out += " + " + values.back() + " + ";
    out += is_quoted(values[i]) ? values[i] : "string(" + values[i] + ')';
  }
  return out;
}

std::optional<std::string> joined_texts(const std::vector<std::string>& texts) {
  std::string out;
  for (const std::string& text : texts) {
    if (text.ends_with(" '") || text.ends_with(" \"")) return std::nullopt;
    out += (out.empty() ? "" : " + ") + as_factor(text);
  }
  return out;
}

}  // namespace armlet::lang
