#pragma once
// Inputs made of other inputs: the same ones for the same seed.

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace armlet::fuzz {

class Mutator {
 public:
  // `words` are put in now and then.
  Mutator(std::vector<std::string> corpus, std::vector<std::string> words, std::uint64_t seed);

  [[nodiscard]] std::string next();

 private:
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(random_() % n); }
  void mutate(std::string& text);

  std::vector<std::string> corpus_;
  std::vector<std::string> words_;
  std::mt19937_64 random_;
};

// The words of a dictionary in the form of libFuzzer: lines `"text"` with \" \\ and \xAB; other
// lines are comments.
[[nodiscard]] std::vector<std::string> words_of(const std::string& dictionary);

}  // namespace armlet::fuzz
