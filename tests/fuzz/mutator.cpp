#include "mutator.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

namespace armlet::fuzz {
namespace {

constexpr std::size_t kLargest = 4096;  // bytes of an input

}  // namespace

Mutator::Mutator(std::vector<std::string> corpus, std::vector<std::string> words,
                 std::uint64_t seed)
    : corpus_(std::move(corpus)), words_(std::move(words)), random_(seed) {}

std::string Mutator::next() {
  std::string text = corpus_[below(corpus_.size())];
  for (std::size_t i = 1 + below(6); i > 0; --i) mutate(text);
  if (text.size() > kLargest) text.resize(kLargest);
  return text;
}

void Mutator::mutate(std::string& text) {
  const std::size_t at = below(text.size() + 1);
  const std::size_t length = std::min(1 + below(12), text.size() - at);
  switch (below(7)) {
    case 0:
      text.erase(at, length);
      break;
    case 1:
    case 2:
      text.insert(at, words_[below(words_.size())]);
      break;
    case 3:
      text.replace(at, length, words_[below(words_.size())]);
      break;
    case 4: {  // a piece of another input
      const std::string& other = corpus_[below(corpus_.size())];
      const std::size_t from = below(other.size() + 1);
      text.insert(at, other.substr(from, 1 + below(60)));
      break;
    }
    case 5:
      text.insert(at, text.substr(below(text.size() + 1), 1 + below(30)));
      break;
    default:
      if (at < text.size()) text[at] = static_cast<char>(random_());
      break;
  }
}

std::vector<std::string> words_of(const std::string& dictionary) {
  std::vector<std::string> words;
  std::istringstream lines(dictionary);
  for (std::string line; std::getline(lines, line);) {
    if (line.size() < 2 || line.front() != '"' || line.back() != '"') continue;
    std::string word;
    for (std::size_t i = 1; i + 1 < line.size(); ++i) {
      if (line[i] == '\\' && line[i + 1] == 'x') {
        word += static_cast<char>(std::stoi(line.substr(i + 2, 2), nullptr, 16));
        i += 3;
      } else {
        if (line[i] == '\\') ++i;
        word += line[i];
      }
    }
    words.push_back(word);
  }
  return words;
}

}  // namespace armlet::fuzz
