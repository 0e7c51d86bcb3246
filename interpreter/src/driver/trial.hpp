#pragma once
// A program with other text in some places, checked again: what its messages would be.

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "armlet/interpreter/engine.hpp"
#include "vocabulary/registry.hpp"

namespace armlet::lang {

// A file after some edits: what is wrong in it, and where places of the old text are now.
class Trial {
 public:
  // sources  the program after the edits, in which the messages that are left have their marks.
  Trial(std::vector<Edit> in_order, std::shared_ptr<const SourceSet> sources,
        std::vector<Diagnostic> left)
      : edits_(std::move(in_order)), sources_(std::move(sources)), left_(std::move(left)) {}

  // The mark of `repaired` and what the edits wrote, as they lie now.
  [[nodiscard]] std::vector<Span> places(const Diagnostic& repaired) const;
  // Whether an error, or a message with the code of `repaired`, touches one of these places.
  [[nodiscard]] bool fails_at_its_places(const Diagnostic& repaired) const;
  // Whether an error stands in a part of the old text.
  [[nodiscard]] bool fails_inside(Span part) const;
  [[nodiscard]] const SourceSet& sources() const { return *sources_; }
  [[nodiscard]] const std::vector<Diagnostic>& left() const { return left_; }
  // Whether a message of the old text is still there.
  [[nodiscard]] bool still_says(const Diagnostic& message) const;

 private:
  // Where a place of the old text is; a position inside of what is replaced: at its end.
  [[nodiscard]] Span moved(Span place) const;

  std::vector<Edit> edits_;
  std::shared_ptr<const SourceSet> sources_;
  std::vector<Diagnostic> left_;
};

[[nodiscard]] inline bool touch(Span a, Span b) { return a.begin <= b.end && b.begin <= a.end; }

// Checks a program again and again. The work is bounded: nothing is tried when more than 256 KB of
// text have been read again.
class Trials {
 public:
  // sources  the texts of the program, which must outlive this.
  // options  `load` is asked again for the files that the program imports.
  Trials(const Registry& registry, const SourceSet& sources, const CompileOptions& options);

  // Further edits of what a trial has changed. They count against the same bound.
  [[nodiscard]] Trials behind(const Trial& first) const;
  [[nodiscard]] bool is_behind_another() const { return behind_another_; }

  [[nodiscard]] bool exhausted() const { return *read_ + all_ > kMostBytes; }
  // The program with edits of one file. Nothing if they overlap or belong to several files, or if
  // the bound is reached.
  [[nodiscard]] std::optional<Trial> with(std::vector<Edit> edits);

 private:
  static constexpr std::size_t kMostBytes = 256U << 10U;

  const Registry& registry_;
  const SourceSet& sources_;
  const CompileOptions& options_;
  std::size_t all_ = 0;
  std::shared_ptr<std::size_t> read_ = std::make_shared<std::size_t>(0);
  bool behind_another_ = false;
};

}  // namespace armlet::lang
