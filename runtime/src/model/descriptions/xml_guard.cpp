#include "xml_guard.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

namespace armlet {
namespace {

constexpr std::size_t kMaxBytes = 16 << 20;
constexpr std::size_t kMaxDepth = 100;
constexpr std::size_t kMaxElements = 100'000;
constexpr std::size_t kMaxAttributes = 100;
constexpr std::size_t kMaxName = 200;
constexpr std::size_t kMaxValue = 10'000;
constexpr std::size_t kMaxText = 1'000'000;
constexpr std::size_t kMaxAsides = 10'000;
constexpr std::size_t kMaxEntities = 100'000;
constexpr std::size_t kMaxEntity = 10;

constexpr std::string_view kBlank = " \t\r\n";

// Bytes above ASCII are letters of some alphabet.
bool starts_name(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || byte == '_' ||
         byte == ':' || byte >= 0x80;
}
bool continues_name(char c) {
  return starts_name(c) || (c >= '0' && c <= '9') || c == '-' || c == '.';
}

// Control characters that XML 1.0 (2.2) leaves out.
bool is_forbidden(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return byte < 0x20 && kBlank.find(c) == std::string_view::npos;
}

// Whether an entity, without its & and ;, encodes such a character: "#1", "#x1F".
bool names_forbidden(std::string_view entity) {
  if (!entity.starts_with('#')) return false;
  const bool is_hex = entity.substr(1).starts_with('x');
  entity.remove_prefix(is_hex ? 2 : 1);
  unsigned code = 0;
  const auto [end, error] =
      std::from_chars(entity.data(), entity.data() + entity.size(), code, is_hex ? 16 : 10);
  return error == std::errc() && end == entity.data() + entity.size() && code < 0x20 &&
         is_forbidden(static_cast<char>(code));
}

// Scans the text once, from tag to tag, and counts.
class Walk {
 public:
  explicit Walk(std::string_view text) : text_(text) {}

  std::string fault() {
    while (fault_.empty() && at_ < text_.size()) {
      text();
      if (fault_.empty() && at_ < text_.size()) markup();
    }
    if (!fault_.empty()) return std::move(fault_);
    const auto total = [](std::size_t given, std::size_t most, std::string_view what) {
      if (given <= most) return std::string();
      return fmt::format("the file has {} {}; at most {} are read", given, what, most);
    };
    std::string excess = total(elements_, kMaxElements, "elements");
    if (excess.empty()) excess = total(entities_, kMaxEntities, "entities");
    if (excess.empty())
      excess = total(asides_, kMaxAsides, "comments, instructions and sections of plain text");
    return excess;
  }

 private:
  void refuse(std::string what) {
    const auto here = text_.begin() + static_cast<std::ptrdiff_t>(std::min(at_, text_.size()));
    fault_ = fmt::format("{} (line {})", what, 1 + std::count(text_.begin(), here, '\n'));
  }
  // False, with an error set, if a count exceeds its limit.
  bool within(std::size_t given, std::size_t most, std::string_view what, std::string_view unit) {
    if (given <= most) return true;
    refuse(fmt::format("{} has {} {}; at most {} are read", what, given, unit, most));
    return false;
  }

  [[nodiscard]] bool looking_at(std::string_view begin) const {
    return text_.substr(at_, begin.size()) == begin;
  }
  [[nodiscard]] char next() const { return at_ < text_.size() ? text_[at_] : '\0'; }
  void skip_blank() { at_ = std::min(text_.find_first_not_of(kBlank, at_), text_.size()); }

  // Scans text up to the next tag.
  void text() {
    const std::size_t end = std::min(text_.find('<', at_), text_.size());
    if (!within(end - at_, kMaxText, "the text between two tags", "bytes")) return;
    entities(end);
    if (fault_.empty()) at_ = end;
  }

  // Counts and checks the entities before `end`.
  void entities(std::size_t end) {
    const std::size_t begin = at_;
    const std::string_view here = text_.substr(0, end);
    for (at_ = here.find('&', at_); at_ < end; at_ = here.find('&', at_)) {
      const std::string_view inside = text_.substr(at_ + 1, kMaxEntity);
      const std::size_t length = inside.find_first_of(";&<>\"' \t\r\n");
      if (length == 0 || length >= inside.size() || inside[length] != ';')
        return refuse("a & begins no entity; a & itself is written &amp;");
      if (names_forbidden(inside.substr(0, length))) {
        return refuse(fmt::format("&{}; is a control character, which XML does not allow",
                                  inside.substr(0, length)));
      }
      ++entities_;
      at_ += 1 + length;
    }
    at_ = begin;
  }

  void markup() {
    if (looking_at("<!--")) return aside("-->", "a comment does not end");
    if (looking_at("<![CDATA[")) return aside("]]>", "a section of plain text does not end");
    if (looking_at("<?")) return aside("?>", "an instruction does not end");
    if (looking_at("<!"))
      return refuse("the file declares its own document type; a robot description needs none");
    if (looking_at("</")) return close();
    open();
  }

  void aside(std::string_view last, std::string_view unended) {
    const std::size_t found = text_.find(last, at_);
    if (found == std::string_view::npos) return refuse(std::string(unended));
    ++asides_;
    at_ = found + last.size();
  }

  // The name at this position; empty after an error.
  std::string_view name(std::string_view otherwise) {
    std::size_t end = at_;
    if (starts_name(next())) {
      while (end < text_.size() && continues_name(text_[end])) ++end;
    }
    const std::string_view found = text_.substr(at_, end - at_);
    if (found.empty()) {
      refuse(std::string(otherwise));
    } else if (!within(found.size(), kMaxName, "a name", "bytes")) {
      return {};
    }
    at_ = end;
    return found;
  }

  void close() {
    at_ += 2;
    if (name("a </ is not followed by a name").empty()) return;
    skip_blank();
    if (next() != '>') return refuse("a closing tag holds more than a name");
    ++at_;
    depth_ -= depth_ > 0 ? 1 : 0;
  }

  void open() {
    ++at_;
    const std::string_view element = name("a < begins no tag; a < itself is written &lt;");
    if (element.empty()) return;
    ++elements_;
    const std::size_t count = attributes(element);
    if (!fault_.empty() ||
        !within(count, kMaxAttributes, fmt::format("<{}>", element), "attributes"))
      return;
    const bool is_empty = next() == '/';
    at_ += is_empty ? 2 : 1;
    if (!is_empty && ++depth_ > kMaxDepth)
      refuse(fmt::format("its elements are nested more than {} deep", kMaxDepth));
  }

  // Scans up to the end of the tag, /> or >.
  std::size_t attributes(std::string_view element) {
    for (std::size_t count = 0;; ++count) {
      const std::size_t before = at_;
      skip_blank();
      if (next() == '>' || looking_at("/>")) return count;
      if (at_ >= text_.size()) {
        refuse(fmt::format("the tag <{}> does not end", element));
      } else if (at_ == before) {
        refuse(fmt::format("a blank is missing in the tag <{}>", element));
      } else {
        attribute(element);
      }
      if (!fault_.empty()) return count;
    }
  }

  void attribute(std::string_view element) {
    const auto broken = [&] {
      refuse(fmt::format("an attribute of <{}> is not written name=\"value\"", element));
    };
    if (name(fmt::format("an attribute of <{}> has no name", element)).empty()) return;
    skip_blank();
    if (next() != '=') return broken();
    ++at_;
    skip_blank();
    const char quote = next();
    if (quote != '"' && quote != '\'') return broken();
    ++at_;
    const std::size_t end = text_.find(quote, at_);
    if (end == std::string_view::npos)
      return refuse(fmt::format("the value of an attribute of <{}> does not end", element));
    if (!within(end - at_, kMaxValue, fmt::format("a value in <{}>", element), "bytes")) return;
    if (text_.substr(at_, end - at_).find('<') != std::string_view::npos)
      return refuse(fmt::format(
          "the value of an attribute of <{}> holds a <, which is written &lt;", element));
    entities(end);
    if (fault_.empty()) at_ = end + 1;
  }

  std::string_view text_;
  std::size_t at_ = 0;
  std::size_t depth_ = 0, elements_ = 0, asides_ = 0, entities_ = 0;
  std::string fault_;
};

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
  if (text.find_first_not_of(kBlank) == std::string_view::npos) return "the file is empty";
  const auto control = std::ranges::find_if(text, is_forbidden);
  if (control != text.end()) {
    return fmt::format(
        "it holds the control character U+{:04X}, which XML does not allow (line {})",
        static_cast<unsigned>(*control), 1 + std::count(text.begin(), control, '\n'));
  }
  return Walk(text).fault();
}

}  // namespace armlet
