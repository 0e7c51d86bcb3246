#include "format/gaps.hpp"

#include "format/doc.hpp"

namespace armlet::lang {
namespace {

constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";  // has no width

int count_breaks(std::string_view text) {
  int count = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool second_half = text[i] == '\n' && i > 0 && text[i - 1] == '\r';
    if ((text[i] == '\n' || text[i] == '\r') && !second_half) ++count;
  }
  return count;
}

// Comments before the first line break belong to the line of the token before.
void find_line_end(Gap& gap) {
  if (!gap.has_break()) return;
  while (gap.at_end < gap.comments.size() && gap.comments[gap.at_end].breaks_before == 0)
    ++gap.at_end;
}

std::string_view without_blanks_at_end(std::string_view text) {
  const std::size_t last = text.find_last_not_of(" \t\f\v\r");
  return text.substr(0, last == std::string_view::npos ? 0 : last + 1);
}

}  // namespace

int display_column(const Source& source, std::uint32_t offset) {
  std::string_view before = source.text().substr(0, offset);
  if (const std::size_t at = before.find_last_of("\r\n"); at != std::string_view::npos)
    before.remove_prefix(at + 1);
  const bool is_first_line = before.data() == source.text().data();
  while (is_first_line && before.starts_with(kByteOrderMark))
    before.remove_prefix(kByteOrderMark.size());
  return text_width(before);
}

std::vector<Gap> read_gaps(const Source& source, const Shape& shape, std::uint32_t begin) {
  std::vector<Gap> gaps(shape.tokens.size());
  auto comment = shape.comments.begin();
  std::uint32_t at = begin;
  const auto breaks_up_to = [&](std::uint32_t end) {
    return count_breaks(source.text().substr(at, end - at));
  };
  for (std::size_t i = 0; i < gaps.size(); ++i) {
    const Token& token = shape.tokens[i];
    if (token.inserted) continue;
    for (; comment != shape.comments.end() && comment->begin < token.begin; ++comment) {
      gaps[i].comments.push_back({without_blanks_at_end(source.slice(*comment)),
                                  display_column(source, comment->begin),
                                  breaks_up_to(comment->begin)});
      at = comment->end;
    }
    gaps[i].breaks_before = breaks_up_to(token.begin);
    at = token.end;
    if (i + 1 == gaps.size() && gaps[i].breaks_before == 0) gaps[i].breaks_before = 1;
    if (i > 0) find_line_end(gaps[i]);
  }
  return gaps;
}

}  // namespace armlet::lang
