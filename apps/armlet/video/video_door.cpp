#include "video/video_door.hpp"

#include <string>

#include "armlet/core/platform.hpp"

namespace armlet::cli {

const VideoDoor* video_door() {
  static const VideoDoor* const door = []() -> const VideoDoor* {
    for (const std::string& folder : {program_folder() + "/../lib/", program_folder() + '/', {}}) {
      const LoadedLibrary library(folder + kVideoLibrary);
      if (void* const symbol = library.find(kOpenVideoDoor))
        return reinterpret_cast<OpenVideoDoor>(symbol)();
    }
    return nullptr;
  }();
  return door;
}

}  // namespace armlet::cli
