#pragma once
// The signatures of library functions, each read when it is first needed.

#include <memory>
#include <unordered_map>

#include "vocabulary/registry.hpp"
#include "vocabulary/signature.hpp"

namespace armlet::lang {

class Signatures {
 public:
  Signatures(const Registry& registry, TypePool& types) : registry_(registry), types_(types) {}

  // It stays where it is.
  [[nodiscard]] const Signature& of(const NativeFunction& function);

 private:
  const Registry& registry_;
  TypePool& types_;
  std::unordered_map<const NativeFunction*, std::unique_ptr<Signature>> known_;
};

}  // namespace armlet::lang
