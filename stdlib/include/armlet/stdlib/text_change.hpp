#pragma once

#include <cstdint>

namespace armlet {

// The effect of another text on a run (Session::change).
//
// kRefused  It does not compile; or it is an entry that fails before that time (entries
//           that fail are rolled back, so that time does not exist); or it was
//           cancelled. problems() says why. Nothing has changed.
// kSame     All events up to that time are the same as before.
// kParts    They differ from `parts_ns` on, when the new program was at `line` of its
//           file; the run is at the requested time nevertheless, or has ended before
//           it.
struct TextChange {
  enum class Outcome : std::uint8_t { kRefused, kSame, kParts };
  Outcome outcome = Outcome::kRefused;
  std::int64_t same_ns = 0;   // kParts: time of the last equal event
  std::int64_t parts_ns = 0;  // kParts: time of the first different event
  int line = 0;               // kParts; 0: the program has not begun
};

}  // namespace armlet
