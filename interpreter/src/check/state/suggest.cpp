#include "check/state/suggest.hpp"

#include <algorithm>

#include "armlet/core/similar.hpp"

namespace armlet::lang {

std::optional<Candidate> suggest(std::string_view name, std::span<const Candidate> candidates,
                                 const Type* wanted) {
  std::optional<Candidate> best;
  std::size_t best_score = 0;
  for (const Candidate& candidate : candidates) {
    const std::string_view one[] = {candidate.name};
    if (candidate.name == name || !most_similar(name, one)) continue;
    const bool other_type = wanted != nullptr && candidate.type != wanted;
    // Another type counts as one and a half edits, so that with equal distances a fitting type is
    // preferred.
    const std::size_t score = 2 * edit_distance(name, candidate.name) + (other_type ? 3 : 0);
    if (best && score >= best_score) continue;
    best = candidate;
    best_score = score;
  }
  return best;
}

std::optional<std::string_view> suggest(std::string_view name,
                                        std::span<const std::string_view> candidates) {
  return most_similar(name, candidates);
}

}  // namespace armlet::lang
