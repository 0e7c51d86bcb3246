#include "hir/program_names.hpp"

namespace armlet::lang {

void BlockNames::add(const std::string& type, std::string_view name) {
  OfType& names = types_[type];
  names.in_order.emplace_back(name);
  names.all.emplace(name);
}

std::vector<std::string> BlockNames::of(std::string_view type) const {
  const auto found = types_.find(type);
  std::vector<std::string> names =
      before_ != nullptr ? before_->of(type) : std::vector<std::string>();
  if (found != types_.end())
    names.insert(names.end(), found->second.in_order.begin(), found->second.in_order.end());
  return names;
}

bool BlockNames::has(std::string_view type, std::string_view name) const {
  const auto found = types_.find(type);
  if (found != types_.end() && found->second.all.contains(std::string(name))) return true;
  return before_ != nullptr && before_->has(type, name);
}

std::map<std::string, std::vector<std::string>, std::less<>> BlockNames::all() const {
  std::map<std::string, std::vector<std::string>, std::less<>> names;
  for (const auto& [type, of_type] : types_) names.emplace(type, of_type.in_order);
  return names;
}

}  // namespace armlet::lang
