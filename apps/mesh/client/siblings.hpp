#pragma once
// The files that a mesh names: only those of its own folder and below it.

#include <string>
#include <string_view>

#include "armlet/core/files.hpp"
#include "exchange.hpp"

namespace armlet::mesh {

// A file, or why there is none.
struct Sibling {
  Say state = Say::kAbsent;
  std::string text;  // its bytes (kFile), or the reason as a sentence without an end
};

// A name as files of other systems write it ("..\x.jpg", ".\Tex.jpg", "C:\x.jpg", "file:x.jpg")
// with / between its parts and without those that stand for where they are; an error if it leads
// out of the folder, from a root or over a network.
[[nodiscard]] Result<std::string> sibling_name(std::string_view name);

class Siblings {
 public:
  // folder  what is granted; `below`: the part of it that the mesh lies in, empty or ending in /.
  // path    of the folder, to look for names in another case.
  Siblings(const Folder& folder, std::string path, std::string below)
      : folder_(folder), path_(std::move(path)), below_(std::move(below)) {}

  // Looks for a name as it is written, then with its %20 read, then in another case: the first in
  // the order of the alphabet. No link is followed.
  [[nodiscard]] Sibling find(std::string_view name, std::size_t most) const;

 private:
  [[nodiscard]] Sibling read(const std::string& name, std::size_t most) const;
  [[nodiscard]] std::string in_another_case(const std::string& name) const;

  const Folder& folder_;
  std::string path_;
  std::string below_;
};

}  // namespace armlet::mesh
