#pragma once
// Pictures that cameras take, at once or with their next frame.

#include <memory>

#include "armlet/image/image.hpp"
#include "armlet/interpreter/native.hpp"
#include "values/values.hpp"
#include "values/world/cameras.hpp"

namespace armlet::bind {

// Notes what is known of a camera from the text: whether it takes pictures at a rate.
void note_rate(CheckCall& call, CallPart rate);
// A call on a camera that has a rate, or may have one, takes time.
void check_rate(CheckCall& call, CallPart camera);

// The RGB picture at this instant, counted and reported to listeners. from: pose of the tool point
// (for cameras on robots) or of the camera.
Answer<Image> capture(Vm& vm, const CameraRef& camera, const PosC* from);
// The next frame of a camera with a rate; a picture at once if it has no rate.
Answer<std::unique_ptr<Waiting>> capture_next(Vm& vm, const CameraRef& camera, const PosC* from);

}  // namespace armlet::bind
