#pragma once
// Settings whose value is known from the text are checked before the run: E0534.
//
// The run checks the same limits, for values that are computed.

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/interpreter/native.hpp"

namespace armlet::bind {

// The word nearest to a misspelt one, as a fix; nullopt if none is near.
[[nodiscard]] std::optional<Fix> meant_word(std::string_view written,
                                            const std::vector<std::string_view>& words, Span span);

// "a", "b" or "c"
[[nodiscard]] std::string choice_of(std::span<const std::string_view> words);

// Checks a text that must be one of some words.
//
// setting  the name that the message gives; empty: none.
void check_words(CheckCall& call, CallPart part, std::span<const std::string_view> words,
                 std::string_view setting = {});
template <ParameterName kName, const auto& kWords>
void check_word(CheckCall& call) {
  check_words(call, kPart<kName>, kWords);
}

// Checks the name of a method of integration.
void check_method_word(CheckCall& call, CallPart part);
template <ParameterName kName>
void check_method(CheckCall& call) {
  check_method_word(call, kPart<kName>);
}

// Checks a file name that must have one of some extensions: ".svg".
void check_endings(CheckCall& call, CallPart part, std::span<const std::string_view> endings);
template <ParameterName kName, const auto& kEndings>
void check_ending(CheckCall& call) {
  check_endings(call, kPart<kName>, kEndings);
}

// Checks a fraction of the limits of the joints: above 0 and at most 1.
void check_fraction(CheckCall& call, CallPart part);

// Checks a speed or an acceleration: above 0.
void check_positive(CheckCall& call, CallPart part);

// Checks an inertia whose size is known from the text: three rows of three numbers.
void check_inertia_size(CheckCall& call, CallPart part);
template <ParameterName kName>
void check_inertia(CheckCall& call) {
  check_inertia_size(call, kPart<kName>);
}

}  // namespace armlet::bind
