#pragma once
// What the command and the converter, two processes, say to each other over one socket.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace armlet::mesh {

// The process that reads files of others has no more than this.
//
// memory   bytes of address space.
// cpu      s of computing.
// wall     s from start to end.
// file     bytes of one file; all files that one conversion reads have at most twice as many.
// files    names that it may ask for.
// result   bytes of the GLB; more are not read as a mesh.
struct ConvertLimits {
  std::size_t memory = std::size_t{3} << 30;
  int cpu = 60;
  int wall = 120;
  std::size_t file = std::size_t{128} << 20;
  int files = 256;
  std::size_t result = std::size_t{128} << 20;
};

// From the converter: it wants a file, has got so far, has made the GLB, or gives a reason.
// From the command: a file, or why there is none (kAbsent: there is no such file; kOutside: its
// name leads out of the folder; kUnusable: it is there and cannot be read).
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

// The header of a message: what it is, and the length of the text behind it.
std::string say_header(Say what, std::size_t length);
std::size_t said_length(const char* header);

// A text of a file as it can be shown: one line of UTF-8, with ? for other bytes.
std::string shown_text(std::string_view text);

}  // namespace armlet::mesh
