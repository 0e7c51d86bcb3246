#pragma once
// Results of earlier conversions, found by their inputs and used only if their hash is still
// right.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "client/siblings.hpp"

namespace armlet::mesh {

// A file that a conversion has requested.
struct Asked {
  std::string name;  // as the mesh names it
  std::string hash;  // of the contents it got
};
std::string hash_of(const Sibling& sibling);

// The most bytes that all files of the folder may have together.
inline constexpr std::uintmax_t kMostCached = std::uintmax_t{1} << 30;

// Two files for a conversion: KEY.names lists the files that it requested and the hash of the
// result; HASH.glb is the result, where HASH is the hash of the mesh, these files and the
// converter. If the cache is full, the least recently used files are removed.
class Cache {
 public:
  // folder  is made if it does not exist; empty, or if it cannot be made: nothing is stored.
  // key     hash of the mesh, the converter and its arguments.
  // most    bytes of all files together.
  Cache(std::string folder, std::string key, std::uintmax_t most = kMostCached);

  // The result for the same files, if none of them has changed.
  [[nodiscard]] std::optional<std::string> find(
      const std::function<Sibling(const std::string& name)>& find) const;
  void keep(const std::vector<Asked>& asked, const std::string& glb) const;

 private:
  [[nodiscard]] std::string result_name(const std::vector<Asked>& asked) const;

  void make_room() const;
  void mark_used(const std::string& name) const;

  std::optional<Folder> folder_;
  std::string path_;
  std::string key_;
  std::uintmax_t most_;
};

}  // namespace armlet::mesh
