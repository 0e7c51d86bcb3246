#pragma once
// Source texts, spans of bytes in them, and their lines and columns.

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace armlet {

// Bytes [begin, end) of source number `source` of a program.
struct Span {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
  std::uint32_t source = 0;

  [[nodiscard]] bool empty() const { return begin == end; }
  bool operator==(const Span&) const = default;
};

// The smallest span that covers both; they must belong to the same source.
[[nodiscard]] Span cover(Span a, Span b);

// Line and column, counted from 1; columns are characters (code points).
struct Position {
  int line = 1;
  int column = 1;
  bool operator==(const Position&) const = default;
};

// One text with a name. It never changes.
class Source {
 public:
  Source(std::string name, std::string text, std::uint32_t id = 0);

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] std::string_view text() const { return text_; }
  [[nodiscard]] std::uint32_t id() const { return id_; }
  [[nodiscard]] Position position(std::uint32_t offset) const;
  // The text of line `line` (from 1) without its line break; empty if there is no such line.
  [[nodiscard]] std::string_view line(int line) const;
  [[nodiscard]] int line_count() const { return static_cast<int>(line_starts_.size()); }
  // The position of the first byte of line `line` (from 1).
  [[nodiscard]] std::uint32_t line_start(int line) const;
  [[nodiscard]] std::string_view slice(Span span) const;

 private:
  std::string name_;
  std::string text_;
  std::uint32_t id_;
  std::vector<std::uint32_t> line_starts_;
};

// The sources of one program, by number: the main file first, then its imports. The numbers of an
// entry of a session follow those of earlier entries, whose sources are included.
class SourceSet {
 public:
  explicit SourceSet(std::shared_ptr<const SourceSet> before = nullptr);
  ~SourceSet();
  SourceSet(const SourceSet&) = delete;
  SourceSet& operator=(const SourceSet&) = delete;

  const Source& add(std::string name, std::string text);
  [[nodiscard]] const Source& operator[](std::uint32_t id) const;
  // The number of the main file; and the first number without a source.
  [[nodiscard]] std::uint32_t first() const { return first_; }
  [[nodiscard]] std::size_t size() const { return first_ + sources_.size(); }
  [[nodiscard]] std::string_view slice(Span span) const { return (*this)[span.source].slice(span); }
  [[nodiscard]] Position position(Span span) const {
    return (*this)[span.source].position(span.begin);
  }

 private:
  std::vector<std::unique_ptr<Source>> sources_;
  std::uint32_t first_ = 0;
  mutable std::shared_ptr<const SourceSet> before_;
  // A set many entries before this one, so that any set is found in a logarithmic number of steps:
  // Myers, "An applicative random-access stack", Information Processing Letters 17, 1983.
  const SourceSet* far_ = nullptr;
  std::uint32_t depth_ = 0;
};

}  // namespace armlet
