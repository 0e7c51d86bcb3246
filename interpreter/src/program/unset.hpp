#pragma once
// Elements that have no value yet: `new point[2]` makes a list of null references. Only a program
// that makes such lists pays for looking at what it reads from lists of their types.

#include <memory>
#include <unordered_map>
#include <unordered_set>

#include "hir/hir.hpp"
#include "hir/zero.hpp"

namespace armlet::lang {

class UnsetElements {
 public:
  // types  of the elements that the program leaves without a value.
  explicit UnsetElements(hir::Seq<const Type*> types = {}) {
    if (!types.empty()) sets().types.insert(types.begin(), types.end());
  }

  // Of an entry: other entries may leave any elements without a value that have none by nature.
  [[nodiscard]] static UnsetElements anything() {
    UnsetElements out;
    out.anything_ = true;
    return out;
  }

  // Whether an element of this type may be not set.
  [[nodiscard]] bool is_element(const Type* type) const {
    return anything_ ? !has_zero(*type) : sets_ != nullptr && sets_->types.contains(type);
  }
  // Whether a value of this type may hold, at any depth, an element that is not set. What was found
  // out for a type is known for all types in it too.
  [[nodiscard]] bool may_be_in(const Type* type);
  // The same for a type that has been asked for, or lies in one for which the answer was yes.
  [[nodiscard]] bool is_known_in(const Type* type) const {
    if (sets_ == nullptr) return false;
    const auto found = sets_->known.find(type);
    return found != sets_->known.end() && found->second;
  }

 private:
  // Most programs have nothing in them.
  struct Sets {
    std::unordered_set<const Type*> types{};
    std::unordered_map<const Type*, bool> known{};
  };
  Sets& sets() {
    if (sets_ == nullptr) sets_ = std::make_unique<Sets>();
    return *sets_;
  }

  bool anything_ = false;
  std::unique_ptr<Sets> sets_{};
};

}  // namespace armlet::lang
