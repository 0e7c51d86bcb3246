#pragma once
// Files that are dropped onto a page and kept beside its program: none takes the place of another.

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "armlet/core/error.hpp"

namespace armlet::lab {

// What has a name in the folder. `bytes` are those of a file that can be read.
struct NameInUse {
  bool is_used = false;
  std::string bytes{};
};

// Where a mesh is kept, and how large it is along x, y and z, m.
struct KeptFile {
  std::string name{};
  std::array<double, 3> size{};
};

// Keeps a file under its name, or under "part-2.glb" and so on where something else has that. A
// file of the same bytes is used again. Only GLB files are kept.
//
// look    what has a name.
// save    writes a file under a name that nothing has; the reason if it cannot be.
// returns where it is, or why it is not kept, as a sentence.
[[nodiscard]] Result<KeptFile> keep_beside(
    const std::string& name, const std::string& bytes,
    const std::function<NameInUse(const std::string&)>& look,
    const std::function<std::optional<Error>(const std::string&, const std::string&)>& save);

}  // namespace armlet::lab
