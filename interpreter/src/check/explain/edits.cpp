#include "check/explain/edits.hpp"

namespace armlet::lang {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The text of the line before a position.
std::string line_before(const Checker& checker, Span place) {
  const Source& source = (*checker.into.sources)[place.source];
  const std::uint32_t begin = source.line_start(source.position(place.begin).line);
  return checker.text_of({begin, place.begin, place.source});
}

bool is_blank(const std::string& text) {
  return text.find_first_not_of(" \t") == std::string::npos;
}

}  // namespace

std::string as_operand(const std::string& text) {
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '(' || c == '[') ++depth;
    if (c == ')' || c == ']') --depth;
    const bool is_sign = i == 0 && c == '-';
    const bool is_operator = std::string_view(" +-*/%^\\<>=&|?!").find(c) != std::string_view::npos;
    if (depth == 0 && is_operator && !is_sign) return '(' + text + ')';
  }
  return text;
}

bool is_decimal_number(std::string_view text) {
  for (std::size_t i = text.starts_with('-') ? 1 : 0; i < text.size(); ++i) {
    const char c = text[i];
    const bool is_exponent = c == 'e' || c == 'E';
    const bool is_sign =
        (c == '-' || c == '+') && i > 0 && (text[i - 1] == 'e' || text[i - 1] == 'E');
    if (!is_digit(c) && c != '.' && c != '_' && !is_exponent && !is_sign) return false;
  }
  return !text.empty();
}

Edit at_end_of_block(const Checker& checker, Span brace, const std::string& statement) {
  const std::string before = line_before(checker, brace);
  const Span here{brace.begin, brace.begin, brace.source};
  if (is_blank(before)) return {here, "    " + statement + '\n' + before};
  const std::size_t last = before.find_last_not_of(" \t");
  const auto gap = static_cast<std::uint32_t>(before.size() - last - 1);
  const bool ends = before[last] == ';' || before[last] == '{' || before[last] == '}';
  return {{brace.begin - gap, brace.begin, brace.source}, (ends ? " " : "; ") + statement + ' '};
}

std::vector<Edit> moved_before(const Checker& checker, Span statement, Span to) {
  const Source& source = (*checker.into.sources)[statement.source];
  const std::string indent = line_before(checker, to);
  const std::string before = line_before(checker, statement);
  if (!is_blank(indent) || !is_blank(before)) return {};
  const std::string_view text = source.text();
  std::size_t end = statement.end;
  while (end < text.size() && (text[end] == ' ' || text[end] == ';')) ++end;
  if (end >= text.size() || text[end] != '\n') return {};
  const Span lines{statement.begin - static_cast<std::uint32_t>(before.size()),
                   static_cast<std::uint32_t>(end + 1), statement.source};
  return {{{to.begin, to.begin, to.source}, checker.text_of(statement) + '\n' + indent},
          {lines, ""}};
}

}  // namespace armlet::lang
