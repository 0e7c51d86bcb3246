#pragma once
// The files that pages draw, meshes and pictures, under names computed from their bytes.

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>

namespace armlet::lab {

using FileBytes = std::shared_ptr<const std::string>;  // shared by the runs that show the file

// All functions may be called from any thread. A file exists as long as a run keeps its bytes.
class ShownFiles {
 public:
  // The name of a file: digits and letters. If the same bytes are stored already, `bytes` is set to
  // those.
  std::string keep(FileBytes& bytes);
  // Null: there is no file with this name.
  [[nodiscard]] FileBytes find(std::string_view name) const;

 private:
  mutable std::mutex mutex_;
  std::map<std::string, std::weak_ptr<const std::string>, std::less<>> files_;
};

}  // namespace armlet::lab
