#include "hir/kept.hpp"

#include <algorithm>
#include <utility>

namespace armlet::lang {

const KeptName* KeptFile::find(std::string_view name) const {
  const Bucket* bucket = names.find(key_of(name));
  if (bucket == nullptr) return nullptr;
  const auto found = std::ranges::find(*bucket, name, &KeptName::name);
  return found == bucket->end() ? nullptr : &*found;
}

void KeptFile::set(KeptName name) {
  const std::uint64_t key = key_of(name.name);
  const Bucket* known = names.find(key);
  Bucket bucket = known != nullptr ? *known : Bucket();
  const auto at = std::ranges::find(bucket, name.name, &KeptName::name);
  if (at != bucket.end()) {
    *at = std::move(name);
  } else {
    bucket.push_back(std::move(name));
  }
  names.set(key, std::move(bucket));
}

}  // namespace armlet::lang
