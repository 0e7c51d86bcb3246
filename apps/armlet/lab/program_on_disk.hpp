#pragma once
// The file that `armlet lab FILE` shows, which pages read and write.

#include <string>

#include "armlet/core/files.hpp"

namespace armlet::cli {

// One file in a folder that is held open. It stays the same file whatever happens to the path that
// the user has given: links in that path are followed once, at the start, and a link that takes its
// place later is refused.
class ProgramOnDisk {
 public:
  // path  of a regular file, or of one that does not exist in a folder that does.
  [[nodiscard]] static Result<ProgramOnDisk> open(const std::string& path);

  [[nodiscard]] Result<std::string> read() const;
  // Replaces the file atomically; its permissions stay. Returns why it is unchanged.
  [[nodiscard]] std::optional<Error> write(const std::string& text) const;

 private:
  ProgramOnDisk(Folder folder, std::string path, std::string name)
      : folder_(std::move(folder)), path_(std::move(path)), name_(std::move(name)) {}

  Folder folder_;
  std::string path_;  // absolute, without links
  std::string name_;  // its last part
};

}  // namespace armlet::cli
