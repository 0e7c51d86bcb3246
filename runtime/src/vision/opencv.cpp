#include "armlet/vision/opencv.hpp"

#include <fmt/format.h>

#include <new>

#include "armlet/core/error.hpp"
#include "armlet/core/platform.hpp"
#include "armlet/image/check_kind.hpp"
#include "vision/opencv_call.hpp"

namespace armlet {
namespace {

const OpencvDoor* opencv_door() {
  static const OpencvDoor* const door = []() -> const OpencvDoor* {
    for (const std::string& folder : {program_folder() + "/../lib/", program_folder() + '/', {}}) {
      const LoadedLibrary library(folder + kOpencvLibrary);
      if (void* const symbol = library.find(kOpenOpencvDoor))
        return reinterpret_cast<OpenOpencvDoor>(symbol)();
    }
    return nullptr;
  }();
  return door;
}

OpencvResult& result_in(void* context) { return *static_cast<OpencvResult*>(context); }

double* room_for_numbers(void* context, std::size_t count) try {
  OpencvResult& result = result_in(context);
  result.numbers.resize(count + 1);  // not empty, so that the pointer is not null
  result.numbers.pop_back();
  return result.numbers.data();
} catch (const std::bad_alloc&) {
  return nullptr;
}

std::uint8_t* room_for_picture(void* context, int width, int height, int channels) try {
  OpencvResult& result = result_in(context);
  result.picture = Image(width, height, channels == 3 ? PixelKind::kRgb : PixelKind::kGrey);
  return result.picture.row(0);
} catch (const std::bad_alloc&) {
  return nullptr;
}

void keep_refusal(void* context, const char* why) try {
  result_in(context).refusal = why;
} catch (const std::bad_alloc&) {  // the result reports that there is none
}

}  // namespace

bool has_opencv() { return opencv_door() != nullptr; }

MissingOpencv missing_opencv() {
#ifdef __EMSCRIPTEN__
  return {"a page by itself has no OpenCV",
          "run it in a served laboratory: `armlet lab FILE` on a machine with OpenCV"};
#else
  return {std::string("it was built without OpenCV, or ") + kOpencvLibrary + " was not found",
          "`./dev build vision` installs OpenCV and builds it"};
#endif
}

void check_door_picture(std::string_view function, const Image& image, bool grey,
                        std::int64_t most) {
  if (grey) {
    check_grey(function, image);
  } else {
    check_8_bit(function, image);
  }
  const std::int64_t pixels = std::int64_t{image.width()} * image.height();
  if (pixels > most) {
    throw ArgumentError(
        fmt::format("`{}` takes pictures of {} pixels at most, not {}.", function, most, pixels));
  }
}

DoorPicture door_picture(const Image& image) {
  return {image.width(), image.height(), image.channels(), image.bytes().data()};
}

OpencvResult call_opencv(DoorFunction OpencvDoor::*function, const DoorInput& input,
                         std::initializer_list<double> options) {
  const OpencvDoor* const door = opencv_door();
  if (door == nullptr) throw ArgumentError("OpenCV is needed: " + missing_opencv().why + '.');
  OpencvResult result;
  DoorInput whole = input;
  whole.options = options.begin();
  const DoorResult sink{&result, room_for_numbers, room_for_picture, keep_refusal};
  switch ((door->*function)(&whole, &sink)) {
    case DoorEnd::kDone:
      return result;
    case DoorEnd::kNoMemory:
      throw std::bad_alloc();
    case DoorEnd::kRefused:
      break;
  }
  throw ArgumentError(result.refusal.empty() ? "OpenCV refuses it." : result.refusal + '.');
}

}  // namespace armlet
