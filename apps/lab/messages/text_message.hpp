#pragma once
// A message about a program with resolved positions, so that it no longer needs the texts.

#include <optional>
#include <string>
#include <vector>

#include "armlet/interpreter/diagnostic.hpp"
#include "armlet/stdlib/host.hpp"
#include "text_places.hpp"

namespace armlet::lab {

// span  nullopt: the mark is not in the main text but in `file`.
struct MarkedPlace {
  std::optional<TextSpan> span{};
  std::string file{};
  std::string label{};
};
struct TextFix {
  struct Replacement {
    TextSpan span{};
    std::string text{};
  };
  std::string text{};
  bool is_sure = false;
  std::vector<Replacement> edits{};
};
// when       circumstances of an event in a run, as a sentence; t: its time, s.
// unreached  the goal that could not be reached, if the message is about one.
struct TextMessage {
  bool is_error = true;
  std::string code{};
  std::string message{};
  MarkedPlace place{};
  std::vector<MarkedPlace> related{};
  std::string why{};
  std::optional<TextFix> fix{};
  std::optional<double> t{};
  std::string when{};
  std::optional<UnreachedGoal> unreached{};
};

// Fixes that would change another file are left out.
[[nodiscard]] TextMessage resolved(const Diagnostic& diagnostic, const SourceSet& sources);

}  // namespace armlet::lab
