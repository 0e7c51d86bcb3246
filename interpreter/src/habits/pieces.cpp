#include "habits/pieces.hpp"

#include <algorithm>
#include <array>
#include <cctype>

namespace armlet::lang {
namespace {

constexpr std::size_t kLongestLine = 400;

constexpr std::array<std::string_view, 23> kMarks = {"<<", ">>", "->", "=>", "==", "!=", "~=", "<>",
                                                     "<=", ">=", ":=", "::", "&&", "||", "**", "++",
                                                     "--", "+=", "-=", "*=", "/=", ".^", ".*"};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

bool is_letter(char c) {
  return c == '_' || std::isalpha(static_cast<unsigned char>(c)) != 0 ||
         static_cast<unsigned char>(c) >= 0x80;
}

// The end of a number with its unit: 1.5e-3, 100mm. `1:10` and `a.b` are several pieces.
std::size_t end_of_number(std::string_view text, std::size_t at) {
  while (at < text.size()) {
    const bool is_exponent = (text[at] == 'e' || text[at] == 'E') && at + 2 < text.size() &&
                             (text[at + 1] == '-' || text[at + 1] == '+') && is_digit(text[at + 2]);
    if (is_exponent) {
      at += 2;
    } else if (is_digit(text[at]) || is_letter(text[at])) {
      ++at;
    } else if (text[at] == '.' && (at + 1 == text.size() || !is_letter(text[at + 1]))) {
      ++at;
    } else {
      break;
    }
  }
  return at;
}

// The end of a text: after its closing quote, or the end of the line.
std::size_t end_of_text(std::string_view text, std::size_t at) {
  const char quote = text[at++];
  while (at < text.size() && text[at] != quote) at += text[at] == '\\' ? 2 : 1;
  return std::min(at + 1, text.size());
}

// Whether the quote at `at` follows a value: it is MATLAB's transpose.
bool is_transpose(std::string_view text, std::size_t at) {
  if (text[at] != '\'' || at == 0) return false;
  const char before = text[at - 1];
  const bool is_format = before == 'f' && (at == 1 || !is_letter(text[at - 2]));
  return (is_letter(before) && !is_format) || is_digit(before) || before == ')' || before == ']';
}

Piece piece_at(std::string_view text, std::size_t at) {
  const auto made = [&](std::size_t end, Piece::Kind kind) {
    return Piece{static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end), kind};
  };
  const char c = text[at];
  const bool is_number =
      is_digit(c) || (c == '.' && at + 1 < text.size() && is_digit(text[at + 1]));
  if (is_number) return made(end_of_number(text, at), Piece::Kind::kNumber);
  if (is_letter(c)) {
    std::size_t end = at;
    while (end < text.size() && (is_letter(text[end]) || is_digit(text[end]))) ++end;
    return made(end, Piece::Kind::kWord);
  }
  if ((c == '"' || c == '\'') && !is_transpose(text, at))
    return made(end_of_text(text, at), Piece::Kind::kText);
  for (const std::string_view mark : kMarks) {
    if (text.substr(at).starts_with(mark)) return made(at + mark.size(), Piece::Kind::kMark);
  }
  return made(at + 1, Piece::Kind::kMark);
}

// The longest common subsequence of the pieces of two lines.
std::vector<std::pair<std::size_t, std::size_t>> common_pieces(const Line& from, const Line& to) {
  const std::size_t columns = to.pieces.size() + 1;
  std::vector<std::uint16_t> length((from.pieces.size() + 1) * columns);
  for (std::size_t i = from.pieces.size(); i-- > 0;) {
    for (std::size_t j = to.pieces.size(); j-- > 0;) {
      const bool same = from.piece(i) == to.piece(j);
      length[i * columns + j] =
          same ? static_cast<std::uint16_t>(length[(i + 1) * columns + j + 1] + 1)
               : std::max(length[(i + 1) * columns + j], length[i * columns + j + 1]);
    }
  }
  std::vector<std::pair<std::size_t, std::size_t>> out;
  for (std::size_t i = 0, j = 0; i < from.pieces.size() && j < to.pieces.size();) {
    if (from.piece(i) == to.piece(j)) {
      out.emplace_back(i++, j++);
    } else if (length[(i + 1) * columns + j] >= length[i * columns + j + 1]) {
      ++i;
    } else {
      ++j;
    }
  }
  return out;
}

// The pieces of a line, with numbers separated from their units.
Line with_units_apart(std::string_view text) {
  Line line(text);
  std::vector<Piece> apart;
  for (const Piece& piece : line.pieces) {
    apart.push_back(piece);
    if (piece.kind != Piece::Kind::kNumber) continue;
    const std::size_t digits = std::min(text.find_first_not_of("0123456789.", piece.begin),
                                        static_cast<std::size_t>(piece.end));
    if (digits == piece.end || text[digits] == 'e' || text[digits] == 'E' || text[digits] == 'x')
      continue;
    apart.back().end = static_cast<std::uint32_t>(digits);
    apart.push_back({apart.back().end, piece.end, Piece::Kind::kWord});
  }
  line.pieces = std::move(apart);
  return line;
}

}  // namespace

Line::Line(std::string_view written) : text(written) {
  if (text.size() > kLongestLine) return;
  for (std::size_t at = 0; at < text.size();) {
    if (text[at] == ' ' || text[at] == '\t' || text[at] == '\r') {
      ++at;
      continue;
    }
    if (text.substr(at).starts_with("//")) return;
    pieces.push_back(piece_at(text, at));
    at = pieces.back().end;
  }
}

std::vector<LineEdit> line_edits(std::string_view from, std::string_view to) {
  const Line old_line = with_units_apart(from);
  const Line new_line = with_units_apart(to);
  std::vector<LineEdit> out;
  std::uint32_t old_end = 0, new_end = 0;
  const auto add = [&](std::uint32_t old_begin, std::uint32_t new_begin) {
    const std::string_view gone = from.substr(old_end, old_begin - old_end);
    const std::string_view come = to.substr(new_end, new_begin - new_end);
    if (gone != come) out.push_back({old_end, old_begin, std::string(come)});
  };
  for (const auto& [i, j] : common_pieces(old_line, new_line)) {
    add(old_line.pieces[i].begin, new_line.pieces[j].begin);
    old_end = old_line.pieces[i].end;
    new_end = new_line.pieces[j].end;
  }
  add(static_cast<std::uint32_t>(from.size()), static_cast<std::uint32_t>(to.size()));
  return out;
}

}  // namespace armlet::lang
