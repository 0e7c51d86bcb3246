#pragma once
// Camera pictures that a host supplies instead of rendered ones.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/core/error.hpp"

namespace armlet {

// A request for a picture: its number, from 0, among the pictures that this camera takes, the
// present time, and its size in pixels.
struct FrameRequest {
  std::string_view camera;
  std::uint64_t number = 0;
  std::int64_t t_ns = 0;
  int width = 0;
  int height = 0;
};

// cameras  the names of the cameras whose pictures the host supplies.
// take     returns the bytes of a PNG, JPEG, PGM or PPM file with an RGB picture of that size (from
//          pixels, write_netpbm makes one), or an error whose message continues "no picture:". The
//          log of the session records these bytes. Null: in a session that is replayed from a log.
struct HostFrames {
  std::vector<std::string> cameras;
  std::function<Result<std::string>(const FrameRequest&)> take;
};

}  // namespace armlet
