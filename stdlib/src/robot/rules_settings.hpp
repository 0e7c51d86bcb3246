#pragma once
// Settings whose value the text shows are checked before anything moves: E0534.
//
// The same limits are checked in the run, for values that are computed.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/native.hpp"

namespace armlet::bind {

// The word that a misspelt one comes closest to, as a fix; nothing if none is near.
[[nodiscard]] std::optional<Fix> meant_word(std::string_view written,
                                            const std::vector<std::string_view>& words, Span span);

// "a", "b" or "c"
[[nodiscard]] std::string choice_of(std::span<const std::string_view> words);

// A text that is one of some words.
void check_words(CheckCall& call, int parameter, std::span<const std::string_view> words);
template <int kParameter, const auto& kWords>
void check_word(CheckCall& call) {
  check_words(call, kParameter, kWords);
}

// A method of integration.
void check_method_word(CheckCall& call, int parameter);
template <int kParameter>
void check_method(CheckCall& call) {
  check_method_word(call, kParameter);
}

// The name of a file that ends with one of some endings: ".svg".
void check_endings(CheckCall& call, int parameter, std::span<const std::string_view> endings);
template <int kParameter, const auto& kEndings>
void check_ending(CheckCall& call) {
  check_endings(call, kParameter, kEndings);
}

// A fraction of what the joints can do: above 0 and at most 1.
void check_fraction(CheckCall& call, int parameter);

// A speed or an acceleration, which is above 0.
void check_positive(CheckCall& call, int parameter);

// An inertia whose size the text shows: three rows of three numbers.
void check_inertia_size(CheckCall& call, int parameter);
template <int kParameter>
void check_inertia(CheckCall& call) {
  check_inertia_size(call, kParameter);
}

}  // namespace armlet::bind
