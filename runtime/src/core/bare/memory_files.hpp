#pragma once
// The files of the bare platform, which are in memory. A host puts there what its programs may
// read, and takes out what they have written. Not available on platforms with a file system.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace armlet::memory_files {

// Paths begin at the root, "/job/data.csv", without . and .. and links. Every folder exists.
void put(std::string_view path, std::string_view content);
[[nodiscard]] std::optional<std::string> get(std::string_view path);
// False if there was none.
bool remove(std::string_view path);
// The paths of all files below a folder, sorted.
[[nodiscard]] std::vector<std::string> list(std::string_view folder);

}  // namespace armlet::memory_files
