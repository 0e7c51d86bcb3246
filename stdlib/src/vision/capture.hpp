#pragma once
// Pictures that cameras take, at once or with their next frame.

#include <memory>

#include "armlet/image/image.hpp"
#include "armlet/interpreter/native.hpp"
#include "values/values.hpp"
#include "vision/cameras.hpp"

namespace armlet::bind {

// What the text shows of a camera: whether it takes pictures at a rate.
void note_rate(CheckCall& call, int rate);
// A call on a camera that has a rate, or perhaps has one, takes time.
void check_rate(CheckCall& call, int camera);

// The RGB picture at this instant, counted and told to listeners. from: of the tool point (cameras
// on robots) or of the camera.
Answer<Image> capture(Vm& vm, const CameraRef& camera, const PosC* from);
// The same at the next frame of a camera with a rate; at once, if it has none.
Answer<std::unique_ptr<Waiting>> capture_next(Vm& vm, const CameraRef& camera, const PosC* from);

}  // namespace armlet::bind
