#pragma once
// Files dropped onto a page and saved beside the program: GLB unchanged, other meshes as GLB.

#include <cstddef>
#include <filesystem>
#include <string>

#include "kept_file.hpp"

namespace armlet::cli {

class DroppedFiles {
 public:
  // folder  the folder of the program.
  explicit DroppedFiles(std::string folder) : folder_(std::move(folder)) {}
  ~DroppedFiles();
  DroppedFiles(const DroppedFiles&) = delete;
  DroppedFiles& operator=(const DroppedFiles&) = delete;

  // A material, picture or buffer is stored for meshes that come later, and the returned name is
  // empty: it is not saved in the program's folder.
  //
  // returns  an error whose message is a sentence.
  [[nodiscard]] Result<lab::KeptFile> keep(const std::string& name, const std::string& bytes);

 private:
  [[nodiscard]] Result<std::string> convert(const std::string& name);
  [[nodiscard]] std::optional<Error> put_aside(const std::string& name, const std::string& bytes);

  std::string folder_;
  std::filesystem::path aside_;  // folder of the files for the converter; empty: not made yet
  std::size_t bytes_aside_ = 0;
};

}  // namespace armlet::cli
