#pragma once
// Names that are collected over the whole program, from all of its files.

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <unordered_set>
#include <utility>
#include <vector>

namespace armlet::lang {

// The names of block declarations, by the text of their type.
class BlockNames {
 public:
  // Adds the names of the earlier entries of a session.
  void follow(std::shared_ptr<const BlockNames> before) { before_ = std::move(before); }

  void add(const std::string& type, std::string_view name);
  // The names of one type, in the order of the text.
  [[nodiscard]] std::vector<std::string> of(std::string_view type) const;
  [[nodiscard]] bool has(std::string_view type, std::string_view name) const;
  // All names by type, without those of earlier entries.
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
