#pragma once
// The signatures of library functions, each parsed at its first use.

#include <memory>
#include <unordered_map>

#include "vocabulary/registry.hpp"
#include "vocabulary/signature.hpp"

namespace armlet::lang {

class Signatures {
 public:
  Signatures(const Registry& registry, TypePool& types) : registry_(registry), types_(types) {}

  // The signature of a function. Its address does not change.
  [[nodiscard]] const Signature& of(const NativeFunction& function);

 private:
  const Registry& registry_;
  TypePool& types_;
  std::unordered_map<const NativeFunction*, std::unique_ptr<Signature>> known_;
};

}  // namespace armlet::lang
