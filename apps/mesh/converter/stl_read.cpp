// STL files as they occur: text with words in any case, several solids and names of any kind, and
// binary files whose header begins with "solid" or that have bytes after their last triangle.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <vector>

#include "armlet/mesh/triangle_mesh.hpp"
#include "converter/file_checks.hpp"
#include "converter/refuse.hpp"

namespace armlet::mesh {
namespace {

constexpr std::size_t kHeader = 84, kTriangle = 50, kCount = 80;

bool is_blank(char c) { return c == ' ' || (c >= '\t' && c <= '\r'); }
// Padding after the text of a file: zeros, and the character that ends files of DOS.
bool is_padding(char c) { return c == '\0' || c == '\x1a' || is_blank(c); }

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

bool is_word(std::string_view given, std::string_view word) {
  return std::equal(given.begin(), given.end(), word.begin(), word.end(),
                    [](char a, char b) { return lower(a) == b; });
}

std::string_view without_mark(std::string_view bytes) {
  if (bytes.starts_with("\xef\xbb\xbf")) bytes.remove_prefix(3);
  return bytes;
}

std::uint32_t count_in(std::string_view bytes) {
  std::uint32_t count = 0;
  for (std::size_t k = 4; k-- > 0;)
    count = count << 8 | static_cast<unsigned char>(bytes[kCount + k]);
  return count;
}

// The words of a text, with the line number of the last one.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}

  // Returns an empty word at the end of the text.
  std::string_view next() {
    while (at_ < text_.size() && is_blank(text_[at_])) pass();
    const std::size_t begin = at_;
    word_line_ = line_;
    while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  void skip_line() {
    while (at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '\r') ++at_;
  }
  [[nodiscard]] std::size_t line() const { return word_line_; }

 private:
  void pass() {
    const bool pair = text_[at_] == '\r' && at_ + 1 < text_.size() && text_[at_ + 1] == '\n';
    if (text_[at_] == '\n' || (text_[at_] == '\r' && !pair)) ++line_;
    ++at_;
  }

  std::string_view text_;
  std::size_t at_ = 0, line_ = 1, word_line_ = 1;
};

std::optional<float> number_in(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (end != word.data() + word.size() || error == std::errc::invalid_argument) return {};
  // A number that is too large becomes infinite, and is refused as a coordinate.
  if (error == std::errc::result_out_of_range) value = std::abs(value) > 1.0 ? INFINITY : 0.0;
  return static_cast<float>(value);
}

class TextReader {
 public:
  TextReader(std::string_view text, std::vector<std::string>& notes)
      : words_(text), notes_(notes) {}

  // Returns the triangles as the bytes of a binary file.
  std::string read() {
    bool is_open = false;
    for (std::string_view word = words_.next(); !word.empty(); word = words_.next()) {
      const bool ends = is_word(word, "end") && is_word(words_.next(), "solid");
      if (is_word(word, "facet")) {
        read_facet();
        continue;
      }
      if (is_word(word, "solid")) {
        if (is_open) note_missing_end();
        is_open = true;
      } else if (ends || is_word(word, "endsolid")) {
        is_open = false;
      } else {
        notes_.push_back(fmt::format("line {} begins with \"{}\", which is not read", words_.line(),
                                     shown(word)));
      }
      words_.skip_line();
    }
    if (is_open) note_missing_end();
    if (count_ == 0) refuse("there are no triangles in it");
    std::string out(kHeader, ' ');
    for (std::size_t k = 0; k < 4; ++k)
      out[kCount + k] = static_cast<char>(count_ >> (8 * k) & 0xffU);
    return out += triangles_;
  }

 private:
  static std::string shown(std::string_view word) { return shown_text(word.substr(0, 40)); }

  void note_missing_end() { notes_.emplace_back("`endsolid` is missing: it may be cut off"); }

  // Reads the contents between `facet` and `endfacet`.
  void read_facet() {
    std::array<float, 12> numbers{};
    std::size_t corners = 0;
    for (std::string_view word = words_.next();; word = words_.next()) {
      if (word.empty()) refuse("it is cut off: `endfacet` is missing");
      if (is_word(word, "end")) {
        word = words_.next();
        if (is_word(word, "facet")) break;
        if (is_word(word, "loop")) continue;
      }
      if (is_word(word, "endfacet")) break;
      if (is_word(word, "normal")) {
        read_normal(numbers);
      } else if (is_word(word, "vertex")) {
        for (std::size_t k = 0; k < 3; ++k) {
          const float value = read_number();
          if (corners < 3) numbers[3 + 3 * corners + k] = value;
        }
        ++corners;
      } else if (!is_word(word, "outer") && !is_word(word, "loop") && !is_word(word, "endloop")) {
        refuse_word(word);
      }
    }
    if (corners != 3) {
      refuse(fmt::format("the facet that ends in line {} has {} corners; expected 3", words_.line(),
                         corners));
    }
    add(numbers);
  }

  // The last word of a truncated text may be incomplete.
  void refuse_word(std::string_view word) {
    const std::size_t line = words_.line();
    if (words_.next().empty()) refuse("it is cut off: `endfacet` is missing");
    refuse(fmt::format("line {} has \"{}\" in a facet", line, shown(word)));
  }

  // A normal of length zero or not finite is left out and computed from the corners.
  void read_normal(std::array<float, 12>& numbers) {
    bool is_direction = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::optional<float> value = number_in(words_.next());
      is_direction = is_direction && value && std::isfinite(*value);
      numbers[k] = value.value_or(0.0F);
    }
    if (!is_direction) std::fill_n(numbers.begin(), 3, 0.0F);
  }

  float read_number() {
    const std::string_view word = words_.next();
    if (word.empty()) refuse("it is cut off: `endfacet` is missing");
    const std::optional<float> value = number_in(word);
    if (!value) {
      refuse(
          fmt::format("line {} has \"{}\" where a number should be", words_.line(), shown(word)));
    }
    return *value;
  }

  void add(const std::array<float, 12>& numbers) {
    if (++count_ > kMostTriangles)
      refuse(fmt::format("it has more than {} triangles", kMostTriangles));
    for (const float each : numbers) {
      std::uint32_t bits = 0;
      std::memcpy(&bits, &each, sizeof bits);
      for (std::size_t k = 0; k < 4; ++k) triangles_ += static_cast<char>(bits >> (8 * k) & 0xffU);
    }
    triangles_.append(2, '\0');
  }

  Words words_;
  std::vector<std::string>& notes_;
  std::string triangles_;
  std::uint32_t count_ = 0;
};

bool is_text(std::string_view bytes) {
  if (bytes.substr(0, kHeader).find('\0') != std::string_view::npos) return false;
  const std::string_view first = Words(without_mark(bytes)).next();
  return is_word(first, "solid") || is_word(first, "facet");
}

std::string without_extra(std::string_view bytes, std::vector<std::string>& notes) {
  const auto is_printed = [](char c) { return is_blank(c) || (c >= ' ' && c <= '~'); };
  if (bytes.size() < kHeader) refuse(fmt::format("it is cut off: it has {} bytes", bytes.size()));
  if (std::ranges::all_of(bytes.substr(0, kHeader), is_printed)) {
    refuse(
        fmt::format("it is no STL file: it begins with \"{}\"", Words(bytes).next().substr(0, 40)));
  }
  const std::size_t count = count_in(bytes), there = (bytes.size() - kHeader) / kTriangle;
  if (count != there) {
    refuse(fmt::format("its header says {} triangles, but there are bytes for {}", count, there));
  }
  if (count == 0) refuse("there are no triangles in it");
  const std::size_t size = kHeader + count * kTriangle, extra = bytes.size() - size;
  if (extra > 0) {
    notes.push_back(fmt::format("{} {} behind its {} triangles {} not read", extra,
                                extra == 1 ? "byte" : "bytes", count, extra == 1 ? "is" : "are"));
  }
  return std::string(bytes.substr(0, size));
}

}  // namespace

std::string plain_stl(std::string_view bytes, std::vector<std::string>& notes) {
  const bool is_exact =
      bytes.size() >= kHeader && bytes.size() == kHeader + kTriangle * std::size_t{count_in(bytes)};
  if (is_exact || !is_text(bytes)) return without_extra(bytes, notes);
  std::string_view text = without_mark(bytes);
  while (!text.empty() && is_padding(text.back())) text.remove_suffix(1);
  if (text.find('\0') != std::string_view::npos) refuse("it is no text: it has a byte of 0");
  return TextReader(text, notes).read();
}

}  // namespace armlet::mesh
