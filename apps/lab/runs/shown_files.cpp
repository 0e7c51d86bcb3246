#include "shown_files.hpp"

#include <fmt/format.h>

#include "armlet/core/hash.hpp"

namespace armlet::lab {

std::string ShownFiles::keep(FileBytes& bytes) {
  Fnv1a hash;
  hash.add_bytes(*bytes);
  std::string name = fmt::format("{:016x}{:x}", hash.value(), bytes->size());
  const std::lock_guard lock(mutex_);
  std::erase_if(files_, [](const auto& each) { return each.second.expired(); });
  while (true) {
    const auto [place, is_new] = files_.try_emplace(name, bytes);
    FileBytes known = is_new ? bytes : place->second.lock();
    if (known == nullptr) place->second = known = bytes;
    if (known == bytes || *known == *bytes) {
      bytes = std::move(known);
      return name;
    }
    name += 'z';  // other files with the same hash
  }
}

FileBytes ShownFiles::find(std::string_view name) const {
  const std::lock_guard lock(mutex_);
  const auto found = files_.find(name);
  return found == files_.end() ? nullptr : found->second.lock();
}

}  // namespace armlet::lab
