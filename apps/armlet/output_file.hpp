#pragma once
// A file that a command leaves when it has ended, in the place of the one before.

#include <optional>
#include <string>
#include <vector>

#include "armlet/core/files.hpp"

namespace armlet::cli {

class OutputFile {
 public:
  // what  as messages call it: "trace".
  explicit OutputFile(std::string what) : what_(std::move(what)) {}

  void set_path(std::string path) { path_ = std::move(path); }
  [[nodiscard]] bool is_wanted() const { return !path_.empty(); }
  // Once it is known that it will be written. The texts are files that it must not take the place
  // of. The exit status, after a message if it is not kDone.
  int open(const std::vector<std::string>& texts);
  [[nodiscard]] NewFile& file() { return *file_; }
  // It is not wanted any more: what was written goes.
  void give_up() {
    file_.reset();
    path_.clear();
  }
  // Puts the file in its place. The exit status, as above.
  int finish();

 private:
  int refuse(const std::string& why, int exit) const;

  std::string what_;
  std::string path_;
  std::optional<NewFile> file_;
};

}  // namespace armlet::cli
