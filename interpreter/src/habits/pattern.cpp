#include "habits/pattern.hpp"

#include <algorithm>
#include <cctype>

namespace armlet::lang {
namespace {

bool same_word(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, [](char x, char y) {
    return std::tolower(static_cast<unsigned char>(x)) ==
           std::tolower(static_cast<unsigned char>(y));
  });
}

bool opens_bracket(std::string_view piece) { return piece == "(" || piece == "[" || piece == "{"; }
bool closes_bracket(std::string_view piece) { return piece == ")" || piece == "]" || piece == "}"; }

class Matcher {
 public:
  Matcher(const Line& line, std::size_t last, bool whole, Patience& patience)
      : line_(line), last_(last), whole_(whole), patience_(patience) {}

  std::optional<Found> from(std::size_t first, std::string_view shape) {
    parts_.clear();
    if (!rest(first, shape)) return std::nullopt;
    return Found{first, end_, std::move(parts_)};
  }

 private:
  // Whether the pieces from `at` on match the shape.
  bool rest(std::size_t at, std::string_view shape) {
    if (--patience_ < 0) return false;
    if (shape.empty()) {
      end_ = at;
      return !whole_ || at == last_;
    }
    const std::size_t blank = std::min(shape.find(' '), shape.size());
    const std::string_view element = shape.substr(0, blank);
    const std::string_view behind = shape.substr(std::min(blank + 1, shape.size()));
    if (element == "...") return rest_of_line(at);
    if (element == "|") return at == 0 && line_.pieces[0].begin == 0 && rest(at, behind);
    if (element.size() == 2 && element[0] == '!')
      return at < last_ && line_.piece(at) != element.substr(1) && rest(at, behind);
    if (element == "$" || element == "*") return value(at, behind, element == "*");
    return at < last_ && one(at, element, behind);
  }

  bool rest_of_line(std::size_t at) {
    const std::size_t begin = at < line_.pieces.size() ? line_.pieces[at].begin
                              : at == 0                ? 0
                                                       : line_.pieces[at - 1].end;
    std::string_view text = line_.text.substr(begin);
    while (text.ends_with(' ') || text.ends_with('\r')) text.remove_suffix(1);
    while (text.starts_with(' ')) text.remove_prefix(1);
    parts_.emplace_back(text);
    end_ = line_.pieces.size();
    return true;
  }

  // Matches an element that is one piece.
  bool one(std::size_t at, std::string_view element, std::string_view behind) {
    if (element.size() > 1 && element[0] == '~' && element != "~=") {
      if (at == 0 || line_.pieces[at - 1].end != line_.pieces[at].begin) return false;
      element.remove_prefix(1);
    }
    const Piece::Kind kind = line_.pieces[at].kind;
    const std::string_view text = line_.piece(at);
    const bool is_word = element == "@" && kind == Piece::Kind::kWord;
    const bool is_number = element == "#" && kind == Piece::Kind::kNumber;
    const bool is_text = element == "?" && kind == Piece::Kind::kText;
    if (is_word || is_number || is_text) {
      parts_.emplace_back(text);
      if (rest(at + 1, behind)) return true;
      parts_.pop_back();
      return false;
    }
    if (element.size() == 2 && element[0] == '=' && element[1] >= '1' && element[1] <= '9') {
      const auto number = static_cast<std::size_t>(element[1] - '1');
      return number < parts_.size() && parts_[number] == text && rest(at + 1, behind);
    }
    if (element == "@" || element == "#" || element == "?") return false;
    if (element.size() > 1 && element[0] == '^')
      return element.substr(1) == text && rest(at + 1, behind);
    if (element.size() > 1 && element[0] == '\\') element.remove_prefix(1);
    return same_word(element, text) && rest(at + 1, behind);
  }

  bool try_value(std::size_t at, std::size_t end, std::string_view behind) {
    parts_.emplace_back(line_.text_of(at, end));
    if (rest(end, behind)) return true;
    parts_.pop_back();
    return false;
  }

  // Matches a value: the shortest with which the rest of the shape matches; the longest at the end
  // of a shape that need not match the whole line.
  bool value(std::size_t at, std::string_view behind, bool commas) {
    const bool longest = behind.empty() && !whole_;
    int depth = 0;
    std::size_t end = at;
    for (; end <= last_; ++end) {
      const bool enough = end > at || commas;
      if (enough && depth == 0 && !longest && try_value(at, end, behind)) return true;
      if (patience_ < 0 || end == last_) break;
      const std::string_view piece = line_.piece(end);
      const bool ends = closes_bracket(piece) || ((piece == "," || piece == ";") && !commas);
      if (depth == 0 && ends) break;
      if (depth == 0 && !whole_ && (piece == "=" || piece == "return")) break;
      depth += opens_bracket(piece) ? 1 : closes_bracket(piece) ? -1 : 0;
    }
    return longest && depth == 0 && end > at && try_value(at, end, behind);
  }

  const Line& line_;
  std::size_t last_;
  bool whole_;
  Patience& patience_;
  std::vector<std::string> parts_;
  std::size_t end_ = 0;
};

bool may_begin_value(const Line& line, std::size_t first, std::size_t at) {
  if (at == first) return true;
  const std::string_view before = line.piece(at - 1);
  return opens_bracket(before) || before == "," || before == "=" || before == ":=" ||
         before == "return";
}

}  // namespace

std::optional<Found> match_all(const Line& line, std::size_t first, std::size_t last,
                               std::string_view shape, Patience& patience) {
  if (first >= last) return std::nullopt;
  return Matcher(line, last, true, patience).from(first, shape);
}

std::optional<Found> match_inside(const Line& line, std::size_t first, std::size_t last,
                                  std::string_view shape, Patience& patience) {
  Matcher matcher(line, last, false, patience);
  for (std::size_t at = first; at < last; ++at) {
    if (shape.starts_with('$') && !may_begin_value(line, first, at)) continue;
    if (std::optional<Found> found = matcher.from(at, shape)) return found;
  }
  return std::nullopt;
}

}  // namespace armlet::lang
