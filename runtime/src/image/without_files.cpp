// WebAssembly has neither libpng nor stb.

#include "armlet/core/error.hpp"
#include "armlet/image/files.hpp"

namespace armlet {
namespace {

constexpr const char* kOnlyServed =
    "Files of pictures are read and written where a laboratory is served, not in a page by itself.";

}  // namespace

Result<Image> read_image(std::string_view) { return Error{"picture", kOnlyServed}; }

std::string write_png(const Image&) { throw ArgumentError(kOnlyServed); }
std::string write_jpeg(const Image&, int) { throw ArgumentError(kOnlyServed); }
std::string write_netpbm(const Image&) { throw ArgumentError(kOnlyServed); }

}  // namespace armlet
