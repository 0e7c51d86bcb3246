#pragma once
// The files that a mesh names: only files in or below its own folder.

#include <string>
#include <string_view>

#include "armlet/core/files.hpp"
#include "exchange.hpp"

namespace armlet::mesh {

// A file, or the reason why there is none.
struct Sibling {
  Say state = Say::kAbsent;
  std::string text;  // its bytes (kFile), or the reason as a sentence without a full stop
};

// Converts a name as other systems write it ("..\x.jpg", ".\Tex.jpg", "C:\x.jpg", "file:x.jpg") to
// one with / and without the parts "." and ".."; an error if it leads out of the folder, from a
// root or over a network.
[[nodiscard]] Result<std::string> sibling_name(std::string_view name);

class Siblings {
 public:
  // folder  the folder whose files may be read; `below`: its part that contains the mesh, empty or
  //         ending in /.
  // path    of the folder, to search for names in another case.
  Siblings(const Folder& folder, std::string path, std::string below)
      : folder_(folder), path_(std::move(path)), below_(std::move(below)) {}

  // Searches for the name as it is written, then with %20 decoded, then in another case (the first
  // in alphabetical order). No link is followed.
  [[nodiscard]] Sibling find(std::string_view name, std::size_t most) const;

 private:
  [[nodiscard]] Sibling read(const std::string& name, std::size_t most) const;
  [[nodiscard]] std::string in_another_case(const std::string& name) const;

  const Folder& folder_;
  std::string path_;
  std::string below_;
};

}  // namespace armlet::mesh
