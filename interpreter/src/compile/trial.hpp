#pragma once
// A program with other text in some places, checked again: what its messages would be.

#include <cstddef>
#include <optional>
#include <vector>

#include "armlet/interpreter/engine.hpp"
#include "registry.hpp"

namespace armlet::lang {

// A file after some edits: what is wrong in it, and where places of the old text are now.
class Trial {
 public:
  Trial(std::vector<Edit> in_order, std::vector<Diagnostic> left)
      : edits_(std::move(in_order)), left_(std::move(left)) {}

  // Whether an error, or a message with the code of `repaired`, touches a place that the edits
  // changed or the mark of `repaired`.
  [[nodiscard]] bool fails_at_its_places(const Diagnostic& repaired) const;
  // Whether an error stands in a part of the old text.
  [[nodiscard]] bool fails_inside(Span part) const;
  // Whether a message of the old text is still there.
  [[nodiscard]] bool still_says(const Diagnostic& message) const;

 private:
  // Where a place of the old text is; a position inside of what is replaced: at its end.
  [[nodiscard]] Span moved(Span place) const;

  std::vector<Edit> edits_;
  std::vector<Diagnostic> left_;
};

// Checks a program again and again. The work is bounded: nothing is tried when more than 256 KB of
// text have been read again.
class Trials {
 public:
  // sources  the texts of the program, which must outlive this.
  // options  `load` is asked again for the files that the program imports.
  Trials(const Registry& registry, const SourceSet& sources, const CompileOptions& options);

  [[nodiscard]] bool exhausted() const { return read_ + all_ > kMostBytes; }
  // The program with edits of one file. Nothing if they overlap or belong to several files, or if
  // the bound is reached.
  [[nodiscard]] std::optional<Trial> with(std::vector<Edit> edits);

 private:
  static constexpr std::size_t kMostBytes = 256U << 10U;

  const Registry& registry_;
  const SourceSet& sources_;
  const CompileOptions& options_;
  std::size_t all_ = 0;
  std::size_t read_ = 0;
};

}  // namespace armlet::lang
