// Checks words of VRML 2.0 before Coin reads the file: Coin opens the files of `Inline` while it
// parses, and recurses for each brace.

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

#include "converter/importers.hpp"
#include "converter/refuse.hpp"

namespace armlet::mesh {
namespace {

constexpr int kDeepestNode = 200;

// Nodes that read other files or run programs, including other names that Coin accepts.
constexpr std::array<std::string_view, 11> kRefused = {
    "Inline",       "EXTERNPROTO", "Script", "File",       "WWWInline", "InlineLOD",
    "MovieTexture", "AudioClip",   "SoFile", "VRMLInline", "VRMLScript"};

bool ends_word(char c) {
  return c <= ' ' || c == ',' || c == '{' || c == '}' || c == '[' || c == ']' || c == '"' ||
         c == '#';
}

int line_of(std::string_view text, std::size_t at) {
  return 1 + static_cast<int>(
                 std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
}

void check_header(std::string_view text) {
  if (text.starts_with("\x1f\x8b")) refuse("it is compressed; unpack it with gunzip");
  const std::string_view first = text.substr(0, std::min(text.find_first_of("\r\n"), text.size()));
  if (first.starts_with("#VRML V1.0")) refuse("it is VRML 1.0; expected 2.0 (#VRML V2.0 utf8)");
  if (!first.starts_with("#VRML V2.0 utf8")) refuse("its first line is not #VRML V2.0 utf8");
}

// The position after the end of a quoted text.
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

// The nodes and prototypes that enclose a word, and the number of
// nodes that prototypes make. Coin follows USE inside of the node with
// that name, and a prototype inside of itself, until its stack
// overflows.
class Names {
 public:
  explicit Names(std::string_view text) : text_(text) {}

  void open(std::size_t at, char bracket) {
    if (static_cast<int>(brackets_.size()) >= kDeepestNode) {
      refuse(fmt::format("line {}: more than {} nodes in one another", line_of(text_, at),
                         kDeepestNode));
    }
    Bracket made;
    if (bracket == '{') {
      made.node = std::exchange(node_, {});
      // The body of a prototype is the first {...} after its [...] at the same level.
      if (!prototype_.empty() && brackets_.size() == level_)
        made.prototype = std::exchange(prototype_, {});
    }
    if (!made.node.empty()) ++open_nodes_[made.node];
    brackets_.push_back(std::move(made));
  }

  void close(std::size_t at) {
    if (brackets_.empty()) {
      refuse(fmt::format("line {}: {} closes what was not opened", line_of(text_, at), text_[at]));
    }
    const Bracket done = std::move(brackets_.back());
    brackets_.pop_back();
    if (!done.node.empty()) --open_nodes_[done.node];
    if (!done.prototype.empty()) makes_[done.prototype] = 1.0 + done.made;
    if (!brackets_.empty()) brackets_.back().made += done.prototype.empty() ? done.made : 0.0;
  }

  void word(std::size_t at, const std::string& word) {
    if (before_ == "DEF") {
      node_ = word;
    } else if (before_ == "USE") {
      if (open_nodes_[word] > 0)
        refuse(fmt::format("line {}: the node {} contains itself", line_of(text_, at), word));
    } else if (before_ == "PROTO") {
      if (!makes_.emplace(word, -1.0).second)
        refuse(fmt::format("line {}: PROTO {} is there twice", line_of(text_, at), word));
      prototype_ = word;
      level_ = brackets_.size();
    } else if (const auto made = makes_.find(word); made != makes_.end()) {
      if (made->second < 0.0)
        refuse(fmt::format("line {}: PROTO {} contains itself", line_of(text_, at), word));
      all_ += made->second;
      if (!brackets_.empty()) brackets_.back().made += made->second;
      if (made->second > kMostMade || all_ > kMostMade) {
        refuse(fmt::format("line {}: its prototypes make more than {} nodes", line_of(text_, at),
                           kMostMade));
      }
    }
    before_ = word;
  }

  [[nodiscard]] std::size_t depth() const { return brackets_.size(); }

 private:
  static constexpr double kMostMade = 10'000;
  struct Bracket {
    std::string node;       // name of the node with this bracket
    std::string prototype;  // name of the prototype with this body
    double made = 0.0;      // nodes that prototypes make inside
  };

  std::string_view text_;
  std::vector<Bracket> brackets_;
  std::map<std::string, int> open_nodes_;
  std::map<std::string, double> makes_;
  std::string before_, node_, prototype_;
  std::size_t level_ = 0;
  double all_ = 0.0;
};

// The word that begins at `at`.
std::string_view word_at(std::string_view text, std::size_t at) {
  std::size_t end = at;
  while (end < text.size() && !ends_word(text[end])) ++end;
  const std::string_view word = text.substr(at, end - at);
  if (std::find(kRefused.begin(), kRefused.end(), word) != kRefused.end()) {
    refuse(fmt::format("line {}: `{}` would open another file or run a script, which is not done",
                       line_of(text, at), word));
  }
  return word;
}

}  // namespace

std::string safe_vrml(std::string_view text) {
  check_header(text);
  if (text.find('\0') != std::string_view::npos) refuse("it is no text: it has a byte of 0");
  std::string safe;
  safe.reserve(text.size());
  Names names(text);
  for (std::size_t at = 0; at < text.size();) {
    const char c = text[at];
    std::size_t end = at + 1;
    if (c == '#') {
      end = std::min(text.find_first_of("\r\n", at), text.size());
    } else if (c == '"') {
      end = skip_quoted(text, at);
    } else if (c == '{' || c == '[') {
      names.open(at, c);
    } else if (c == '}' || c == ']') {
      names.close(at);
    } else if (!ends_word(c)) {
      const std::string_view word = word_at(text, at);
      end = at + word.size();
      names.word(at, std::string(word));
    }
    const std::string_view part = text.substr(at, end - at);
    safe += part == "ImageTexture" ? std::string_view("MovieTexture") : part;
    at = end;
  }
  if (names.depth() > 0)
    refuse(fmt::format("it is cut off: {} brackets are not closed", names.depth()));
  return safe;
}

}  // namespace armlet::mesh
