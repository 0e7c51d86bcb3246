// Laws over random cases, run over more of them or over others than the tests do.
#pragma once

#include <cstdint>
#include <cstdlib>

namespace armlet {

inline std::uint64_t number_from_environment(const char* name, std::uint64_t usual) {
  const char* text = std::getenv(name);
  return text != nullptr ? std::strtoull(text, nullptr, 10) : usual;
}

// How many cases: ARMLET_SURVEY, or as many as usual.
inline int survey_count(int usual) {
  return static_cast<int>(
      number_from_environment("ARMLET_SURVEY", static_cast<std::uint64_t>(usual)));
}

// Which cases: ARMLET_SEED, or the usual ones.
inline std::uint64_t survey_seed(std::uint64_t usual) {
  return number_from_environment("ARMLET_SEED", usual);
}

}  // namespace armlet
