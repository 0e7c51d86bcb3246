#include "armlet/core/similar.hpp"

#include <algorithm>
#include <array>

namespace armlet {
namespace {

constexpr std::size_t kLongest = 64;

bool same_but_for_capitals(std::string_view a, std::string_view b) {
  const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
  return std::equal(a.begin(), a.end(), b.begin(), b.end(),
                    [&](char x, char y) { return lower(x) == lower(y); });
}

// The largest number of edits between a mistyped name and a candidate.
std::size_t similar_enough(std::string_view name) {
  constexpr std::size_t kShort = 4;  // with two edits, almost all names of this length are similar
  return name.size() <= kShort ? 1 : std::max<std::size_t>(2, name.size() / 3);
}

}  // namespace

std::size_t edit_distance(std::string_view a, std::string_view b) {
  if (a.size() > kLongest || b.size() > kLongest) return std::max(a.size(), b.size());
  using Row = std::array<std::size_t, kLongest + 1>;
  Row before{};
  Row last{};
  Row row{};
  for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
  for (std::size_t i = 1; i <= a.size(); ++i) {
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replace = last[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
      row[j] = std::min({last[j] + 1, row[j - 1] + 1, replace});
      if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
        row[j] = std::min(row[j], before[j - 2] + 1);
      }
    }
    before = last;
    last = row;
  }
  return last[b.size()];
}

std::optional<std::string_view> most_similar(std::string_view name,
                                             std::span<const std::string_view> candidates) {
  constexpr std::size_t kBeginning = 2;  // the distance of a name that is incomplete
  std::optional<std::string_view> best;
  std::size_t best_distance = kLongest;
  for (const std::string_view candidate : candidates) {
    std::size_t distance = edit_distance(name, candidate);
    if (same_but_for_capitals(name, candidate)) distance = 0;
    const bool begins = (name.size() > 2 && candidate.starts_with(name)) ||
                        (candidate.size() > 2 && name.starts_with(candidate));
    if (begins) distance = std::min(distance, kBeginning);
    if (!begins && distance > similar_enough(name)) continue;
    // Among equally near candidates, one that begins like the name is better.
    const bool begins_better = best && distance == best_distance &&
                               candidate.starts_with(name.substr(0, 1)) &&
                               !best->starts_with(name.substr(0, 1));
    if ((distance < best_distance || begins_better) && distance < candidate.size()) {
      best_distance = distance;
      best = candidate;
    }
  }
  return best;
}

}  // namespace armlet
