#pragma once
// Trials: checks a program after some edits, to find the messages that it would have.

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "armlet/interpreter/engine.hpp"
#include "vocabulary/registry.hpp"

namespace armlet::lang {

// The result of a trial: the messages about the file after the edits, and the new positions of its
// old text.
class Trial {
 public:
  // sources  the program after the edits, which the marks of the remaining messages refer to.
  Trial(std::vector<Edit> in_order, std::shared_ptr<const SourceSet> sources,
        std::vector<Diagnostic> left)
      : edits_(std::move(in_order)), sources_(std::move(sources)), left_(std::move(left)) {}

  // The new positions of the mark of `repaired` and of the edited text.
  [[nodiscard]] std::vector<Span> places(const Diagnostic& repaired) const;
  // Whether an error, or a message with the code of `repaired`, touches one of these positions.
  [[nodiscard]] bool fails_at_its_places(const Diagnostic& repaired) const;
  // Whether an error is in a part of the old text.
  [[nodiscard]] bool fails_inside(Span part) const;
  [[nodiscard]] const SourceSet& sources() const { return *sources_; }
  [[nodiscard]] const std::vector<Diagnostic>& left() const { return left_; }
  // Whether a message of the old text is still there.
  [[nodiscard]] bool still_says(const Diagnostic& message) const;

 private:
  // The new position of a span of the old text. A position inside of replaced text moves to its
  // end.
  [[nodiscard]] Span moved(Span place) const;

  std::vector<Edit> edits_;
  std::shared_ptr<const SourceSet> sources_;
  std::vector<Diagnostic> left_;
};

[[nodiscard]] inline bool touch(Span a, Span b) { return a.begin <= b.end && b.begin <= a.end; }

// Checks a program with different edits. The work is limited: after 256 KB of text no further trial
// is made.
class Trials {
 public:
  // sources  the texts of the program, which must outlive this.
  // options  `load` is called again for the files that the program imports.
  Trials(const Registry& registry, const SourceSet& sources, const CompileOptions& options);

  // Trials with further edits of a text that a trial has changed. They count for the same limit.
  [[nodiscard]] Trials behind(const Trial& first) const;
  [[nodiscard]] bool is_behind_another() const { return behind_another_; }

  [[nodiscard]] bool exhausted() const { return *read_ + all_ > kMostBytes; }
  // Checks the program with edits of one file. Empty if they overlap or belong to several files, or
  // if the limit is reached.
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
