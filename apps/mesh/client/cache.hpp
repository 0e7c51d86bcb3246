#pragma once
// What was converted before, found by what it was made from and trusted only if it is what was
// kept.

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "client/siblings.hpp"

namespace armlet::mesh {

// A file that a conversion has asked for.
struct Asked {
  std::string name;  // as the mesh names it
  std::string hash;  // of what it got
};
std::string hash_of(const Sibling& sibling);

// All files of the folder together have so many bytes at most.
inline constexpr std::uintmax_t kMostCached = std::uintmax_t{1} << 30;

// Two files for a conversion: KEY.names lists the files that it asked for and the hash of the
// result; HASH.glb is the result, HASH being that of the mesh, of these files and of the converter.
// What was used last a long time ago makes room for what is kept.
class Cache {
 public:
  // folder  is made if it is not there; empty, or one that cannot be made: nothing is kept.
  // key     hash of the mesh, of the converter and of what it is told.
  // most    bytes of all its files together.
  Cache(std::string folder, std::string key, std::uintmax_t most = kMostCached);

  // What was made from the same files, if all of it is as it was.
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
