#pragma once
// The files of a conversion, which the command at the other end of the socket sends.

#include <map>
#include <string>
#include <string_view>

#include "exchange.hpp"

namespace armlet::mesh {

// A file, or the reason why there is none.
struct GivenFile {
  Say state = Say::kAbsent;
  std::string text;  // its bytes (kFile), or the reason
};

// This process's end of the socket. If the other end is closed, the process ends.
class Files {
 public:
  // The mesh itself, which is sent first.
  [[nodiscard]] std::string take_input();
  // A file that the mesh names; requested once.
  [[nodiscard]] const GivenFile& find(const std::string& name);

  void tell_stage(std::string_view stage);
  // Sends the result, or the reason of a refusal, and ends the process.
  [[noreturn]] void finish(std::string_view glb);
  [[noreturn]] void fail(std::string_view why);

 private:
  std::map<std::string, GivenFile> given_;
};

}  // namespace armlet::mesh
