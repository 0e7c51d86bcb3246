#pragma once
// Saves files dropped onto a page beside its program, without overwriting another file.

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "armlet/core/error.hpp"

namespace armlet::lab {

// The entry with a name in the folder. `bytes` are its contents if it is a readable file.
struct NameInUse {
  bool is_used = false;
  std::string bytes{};
};

// The name of a saved mesh, and its size along x, y and z, m.
struct KeptFile {
  std::string name{};
  std::array<double, 3> size{};
};

// Saves a file under its name, or under "part-2.glb" and so on if another entry has that name. A
// file with the same bytes is used again. Only GLB files are saved.
//
// look    returns the entry with a name.
// save    writes a file under a new name; returns the reason if it cannot be written. returns the
//         saved file, or why it is not saved, as a sentence.
[[nodiscard]] Result<KeptFile> keep_beside(
    const std::string& name, const std::string& bytes,
    const std::function<NameInUse(const std::string&)>& look,
    const std::function<std::optional<Error>(const std::string&, const std::string&)>& save);

}  // namespace armlet::lab
