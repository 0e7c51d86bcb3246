#include "armlet/core/similar.hpp"

#include <doctest/doctest.h>

#include <vector>

using namespace armlet;

TEST_CASE("edit distance counts insertions, deletions, replacements and swaps") {
  CHECK(edit_distance("", "") == 0);
  CHECK(edit_distance("arm", "arm") == 0);
  CHECK(edit_distance("pAbov", "pAbove") == 1);
  CHECK(edit_distance("kitten", "sitting") == 3);  // Levenshtein's example
  CHECK(edit_distance("ca", "ac") == 1);
  CHECK(edit_distance("", "abc") == 3);
}

TEST_CASE("the most similar name is found, and nothing when none is near") {
  const std::vector<std::string_view> names = {"Syn", "Asyn", "Lin", "Cubic"};
  CHECK(most_similar("Sync", names) == "Syn");
  CHECK(most_similar("syn", names) == "Syn");
  CHECK(most_similar("CUBIC", names) == "Cubic");
  CHECK_FALSE(most_similar("whatever", names));
  CHECK_FALSE(most_similar("x", names));
  const std::vector<std::string_view> robots = {"planar2", "puma560"};
  CHECK(most_similar("puma", robots) == "puma560");
  const std::vector<std::string_view> short_names = {"show", "seed", "inv", "range", "print"};
  for (const std::string_view other : {"stop", "skew", "Link", "rne", "go"})
    CHECK_FALSE(most_similar(other, short_names));
  CHECK(most_similar("shwo", short_names) == "show");
  CHECK(most_similar("ran", short_names) == "range");
  const std::vector<std::string_view> beginnings = {"closings", "close"};
  CHECK(most_similar("clos", beginnings) == "close");
  CHECK(most_similar("closin", beginnings) == "closings");
  CHECK(most_similar("pritn", short_names) == "print");
}
