#pragma once
// The file of a laboratory's program, which the laboratory reads and writes through two functions.

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "armlet/core/error.hpp"

namespace armlet::lab {

// exists  whether the file exists when the laboratory starts. If not, the laboratory starts with
//         another text, and the first save makes the file.
// read    returns the contents; an error whose code is "missing": there is no such file. Null: the
//         laboratory has no file.
// write   replaces the contents as a whole, or returns why they are unchanged, as a part of a
//         sentence.
struct ProgramFile {
  bool exists = true;
  std::function<Result<std::string>()> read{};
  std::function<std::optional<Error>(const std::string& text)> write{};
};

// What a laboratory knows of the file.
struct Document {
  std::string text{};  // when it was last read or written
  bool exists = false;
  // The file was changed by another program while the laboratory had unsaved edits. A save asks.
  bool is_changed = false;
};

// Whether two texts are the same but for the ends of their lines, "\n" or "\r\n".
[[nodiscard]] bool is_same_program(std::string_view a, std::string_view b);

}  // namespace armlet::lab
