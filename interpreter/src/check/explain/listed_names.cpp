#include "check/explain/listed_names.hpp"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

#include "armlet/core/similar.hpp"

namespace armlet::lang {
namespace {

constexpr std::size_t kAll = 15;  // all names are listed up to this count
constexpr std::size_t kSome = 8;  // names that are listed of more

// A name such as "q12" in its parts "q" and 12; empty if it does not end with a number.
struct Numbered {
  std::string_view stem;
  int number = 0;
};
std::optional<Numbered> numbered(std::string_view name) {
  const std::size_t stem = name.find_last_not_of("0123456789");
  const std::size_t digits = name.find_first_of("123456789", stem + 1);
  if (stem == std::string_view::npos || digits == std::string_view::npos) return std::nullopt;
  int number = 0;
  const char* const end = name.data() + name.size();
  if (std::from_chars(name.data() + digits, end, number).ec != std::errc()) return std::nullopt;
  return Numbered{name.substr(0, digits), number};
}

// Names that differ only in consecutive numbers are one entry.
std::vector<std::string> entries_of(const std::vector<std::string>& names) {
  constexpr std::size_t kFew = 3;
  std::map<std::string_view, std::vector<int>> numbers;
  for (const std::string& name : names) {
    if (const auto part = numbered(name)) numbers[part->stem].push_back(part->number);
  }
  for (auto& [stem, all] : numbers) std::ranges::sort(all);
  std::erase_if(numbers, [](const auto& each) {
    const std::vector<int>& all = each.second;
    return all.size() < kFew || all.back() - all.front() + 1 != static_cast<int>(all.size());
  });
  std::vector<std::string> entries;
  for (const std::string& name : names) {
    const auto part = numbered(name);
    const auto row = part ? numbers.find(part->stem) : numbers.end();
    if (row == numbers.end()) {
      entries.push_back(name);
    } else if (part->number == row->second.front()) {
      entries.push_back(name + " to " + std::string(part->stem) +
                        std::to_string(row->second.back()));
    }
  }
  return entries;
}

}  // namespace

std::string listed_names(std::string_view asked, const std::vector<std::string>& names) {
  std::vector<std::string> entries = entries_of(names);
  if (entries.size() > kAll) {
    const std::size_t others = entries.size() - kSome;
    std::ranges::stable_sort(entries, {},
                             [&](const std::string& entry) { return edit_distance(asked, entry); });
    entries.resize(kSome);
    std::ranges::sort(entries);
    entries.push_back(std::to_string(others) + " others");
  }
  std::string out;
  for (std::size_t i = 0; i < entries.size(); ++i)
    out += (i == 0 ? "" : i + 1 < entries.size() ? ", " : " and ") + entries[i];
  return out;
}

}  // namespace armlet::lang
