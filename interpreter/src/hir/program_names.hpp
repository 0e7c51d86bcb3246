#pragma once
// Names that count in the whole program, whichever file they stand in.

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

namespace armlet::lang {

// The names of block declarations, by the type as it is written.
class BlockNames {
 public:
  // Those of the entries before are known too.
  void follow(std::shared_ptr<const BlockNames> before) { before_ = std::move(before); }

  void add(const std::string& type, std::string_view name);
  // In the order of the text.
  [[nodiscard]] std::vector<std::string> of(std::string_view type) const;
  [[nodiscard]] bool has(std::string_view type, std::string_view name) const;
  // Without those of the entries before.
  [[nodiscard]] std::map<std::string, std::vector<std::string>, std::less<>> all() const;

 private:
  struct OfType {
    std::vector<std::string> in_order;
    std::unordered_set<std::string> all;
  };
  std::map<std::string, OfType, std::less<>> types_;
  std::shared_ptr<const BlockNames> before_;
};

// The functions and constants of the library that the program mentions.
class Mentions {
 public:
  void add(std::string_view name) { names_.emplace(name); }
  [[nodiscard]] bool has(std::string_view name) const { return names_.contains(name); }
  [[nodiscard]] const std::set<std::string, std::less<>>& all() const { return names_; }

 private:
  std::set<std::string, std::less<>> names_;
};

}  // namespace armlet::lang
