#pragma once
// What is dropped onto a page, beside the program: GLB as it is, meshes of other formats as GLB.

#include <cstddef>
#include <filesystem>
#include <string>

#include "kept_file.hpp"

namespace armlet::cli {

class DroppedFiles {
 public:
  // folder  of the program.
  explicit DroppedFiles(std::string folder) : folder_(std::move(folder)) {}
  ~DroppedFiles();
  DroppedFiles(const DroppedFiles&) = delete;
  DroppedFiles& operator=(const DroppedFiles&) = delete;

  // A material, a picture or a buffer is kept for the meshes that come after it, and gives a name
  // without letters: nothing of it is in the program's folder.
  //
  // returns  an error whose message is a sentence.
  [[nodiscard]] Result<lab::KeptFile> keep(const std::string& name, const std::string& bytes);

 private:
  [[nodiscard]] Result<std::string> convert(const std::string& name);
  [[nodiscard]] std::optional<Error> put_aside(const std::string& name, const std::string& bytes);

  std::string folder_;
  std::filesystem::path aside_;  // what the converter may read; empty: nothing yet
  std::size_t bytes_aside_ = 0;
};

}  // namespace armlet::cli
