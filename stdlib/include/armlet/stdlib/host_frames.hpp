#pragma once
// Pictures of cameras that a host gives, in the place of those that are drawn.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/core/error.hpp"

namespace armlet {

// Which picture is wanted: the one with this number, from 0, of those that the camera takes, now,
// and its size in pixels.
struct FrameRequest {
  std::string_view camera;
  std::uint64_t number = 0;
  std::int64_t t_ns = 0;
  int width = 0;
  int height = 0;
};

// cameras  the names of those whose pictures the host gives.
// take     the bytes of a PNG, JPEG, PGM or PPM file with an RGB picture of that size, which
//          write_netpbm makes of pixels; or an error whose message goes on from "no picture:". The
//          log of the session keeps these bytes. Null: of a session that is taken again from a log.
struct HostFrames {
  std::vector<std::string> cameras;
  std::function<Result<std::string>(const FrameRequest&)> take;
};

}  // namespace armlet
