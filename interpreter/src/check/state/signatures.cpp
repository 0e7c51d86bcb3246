#include "check/state/signatures.hpp"

#include <string>
#include <utility>

namespace armlet::lang {

const Signature& Signatures::of(const NativeFunction& function) {
  std::unique_ptr<Signature>& known = known_[&function];
  if (known == nullptr) {
    std::string error;
    auto read = parse_signature(function.signature, types_, registry_.type_names(types_), error);
    // Engine::check_signatures reports invalid signatures; such a function is never called.
    known = std::make_unique<Signature>(read ? std::move(*read) : Signature{});
  }
  return *known;
}

}  // namespace armlet::lang
