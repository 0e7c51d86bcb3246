#pragma once
// The messages between the command and the converter, two processes, over one socket.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace armlet::mesh {

// The limits of the process that reads files of unknown origin.
//
// memory   bytes of address space.
// cpu      s of computing.
// wall     s from start to end.
// file     bytes of one file; all files that one conversion reads have at most twice as many.
// files    number of files that it may request.
// result   bytes of the GLB; larger ones cannot be read as a mesh.
struct ConvertLimits {
  std::size_t memory = std::size_t{3} << 30;
  int cpu = 60;
  int wall = 120;
  std::size_t file = std::size_t{128} << 20;
  int files = 256;
  std::size_t result = std::size_t{128} << 20;
};

// From the converter: requests a file, reports progress, sends the GLB, or a reason. From the
// command: a file, or the reason why there is none (kAbsent: there is no such file; kOutside: its
// name leads out of the folder; kUnusable: it exists and cannot be read).
enum class Say : std::uint8_t {
  kWant = 'W',
  kStage = 'S',
  kDone = 'D',
  kFailed = 'E',
  kFile = 'F',
  kAbsent = 'A',
  kOutside = 'O',
  kUnusable = 'U',
};

inline constexpr std::size_t kSayHeader = 5;

// The header of a message: its kind, and the length of the text after it.
std::string say_header(Say what, std::size_t length);
std::size_t said_length(const char* header);

// A text of a file in a form that can be shown: one line of UTF-8, with ? for other bytes.
std::string shown_text(std::string_view text);

}  // namespace armlet::mesh
