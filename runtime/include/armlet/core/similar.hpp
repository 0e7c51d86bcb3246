#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace armlet {

// Letters to insert, delete, replace or swap with a neighbour to get from a to b (optimal string
// alignment, Damerau 1964). Counts bytes; texts of more than 64 bytes count as entirely different.
std::size_t edit_distance(std::string_view a, std::string_view b);

// The candidate most similar to a mistyped name, of several equally similar ones the first; nothing
// if none is similar enough. A candidate that differs in capital letters alone is the most similar,
// and a name that is an incomplete candidate is always similar.
std::optional<std::string_view> most_similar(std::string_view name,
                                             std::span<const std::string_view> candidates);

}  // namespace armlet
