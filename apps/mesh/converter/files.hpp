#pragma once
// The files of a conversion, as the command at the other end of the socket gives them.

#include <map>
#include <string>
#include <string_view>

#include "exchange.hpp"

namespace armlet::mesh {

// A file, or why there is none.
struct GivenFile {
  Say state = Say::kAbsent;
  std::string text;  // its bytes (kFile), or the reason
};

// The end of the socket that this process has. Where the other end is gone, the process ends.
class Files {
 public:
  // The mesh itself, which comes first.
  [[nodiscard]] std::string take_input();
  // What the mesh names; asked for once.
  [[nodiscard]] const GivenFile& find(const std::string& name);

  void tell_stage(std::string_view stage);
  // Either of these is the last word: the process ends.
  [[noreturn]] void finish(std::string_view glb);
  [[noreturn]] void fail(std::string_view why);

 private:
  std::map<std::string, GivenFile> given_;
};

}  // namespace armlet::mesh
