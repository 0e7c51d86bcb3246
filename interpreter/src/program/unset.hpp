#pragma once
// Elements that have no value yet: `new point[2]` makes a list of null references. Only a program
// that makes such lists needs checks when it reads elements of their types.

#include <memory>
#include <unordered_map>
#include <unordered_set>

#include "hir/hir.hpp"
#include "hir/zero.hpp"

namespace armlet::lang {

class UnsetElements {
 public:
  // types  the types of elements that the program creates without a value.
  explicit UnsetElements(hir::Seq<const Type*> types = {}) {
    if (!types.empty()) sets().types.insert(types.begin(), types.end());
  }

  // For entries of a session: other entries may create elements without a value of any type that
  // has no zero value.
  [[nodiscard]] static UnsetElements anything() {
    UnsetElements out;
    out.anything_ = true;
    return out;
  }

  // Whether an element of this type may have no value.
  [[nodiscard]] bool is_element(const Type* type) const {
    return anything_ ? !has_zero(*type) : sets_ != nullptr && sets_->types.contains(type);
  }
  // Whether a value of this type may contain, at any depth, an element without a value. The answer
  // is stored for all types in it.
  [[nodiscard]] bool may_be_in(const Type* type);
  // The stored answer of may_be_in, for a type that it was called for, or that is part of a type
  // for which the answer was yes.
  [[nodiscard]] bool is_known_in(const Type* type) const {
    if (sets_ == nullptr) return false;
    const auto found = sets_->known.find(type);
    return found != sets_->known.end() && found->second;
  }

 private:
  // Null for most programs, which create no such elements.
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
