#pragma once

#include <cstdint>

namespace armlet {

// What became of another text for a run (Session::change).
//
// kRefused  it does not compile, or it is that of an entry and fails on the way to the time:
// entries
//           that fail leave nothing behind, so there is nowhere to go to. problems() says why. Or
//           it was cancelled. All is as it was.
// kSame     nothing that the run told until the time is other than it was.
// kParts    it is, from `parts_ns` on, where the new program had come to `line` of its file; the
//           run is at the time asked for nevertheless, or has ended before.
struct TextChange {
  enum class Outcome : std::uint8_t { kRefused, kSame, kParts };
  Outcome outcome = Outcome::kRefused;
  std::int64_t same_ns = 0;   // kParts: the time of the last event that is the same
  std::int64_t parts_ns = 0;  // kParts: the time of the first that is not
  int line = 0;               // kParts; 0: the program has not begun
};

}  // namespace armlet
