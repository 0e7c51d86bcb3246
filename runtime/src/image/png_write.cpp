#include <fmt/format.h>
#include <png.h>

#include <csetjmp>
#include <string>
#include <utility>

#include "armlet/core/checkpoint.hpp"
#include "armlet/core/error.hpp"
#include "armlet/image/check_kind.hpp"
#include "armlet/image/files.hpp"

namespace armlet {
namespace {

constexpr std::uint64_t kOfByte = 32;  // operations, for a byte of the pixels

// libpng returns from its errors by longjmp, so that nothing with a destructor may live in its
// functions: the bytes have their room before it is called.
struct Output {
  std::string bytes;
  std::string why;
};

void append(png_structp png, png_bytep data, png_size_t count) {
  std::string& bytes = static_cast<Output*>(png_get_io_ptr(png))->bytes;
  if (count > bytes.capacity() - bytes.size()) png_error(png, "its bytes do not fit");
  bytes.append(reinterpret_cast<const char*>(data), count);
}

[[noreturn]] void give_up(png_structp png, png_const_charp why) {
  static_cast<Output*>(png_get_error_ptr(png))->why = why;
  png_longjmp(png, 1);
}

void ignore(png_structp, png_const_charp) {}

class Writer {
 public:
  explicit Writer(const Image& image) : image_(image) {
    png_image sizes{};
    sizes.version = PNG_IMAGE_VERSION;
    sizes.width = width();
    sizes.height = height();
    sizes.format = image.channels() == 3 ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
    out_.bytes.reserve(PNG_IMAGE_PNG_SIZE_MAX(sizes));
    png_ = png_create_write_struct(PNG_LIBPNG_VER_STRING, &out_, give_up, ignore);
    if (png_ != nullptr) info_ = png_create_info_struct(png_);
  }
  ~Writer() { png_destroy_write_struct(&png_, &info_); }
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;

  // throws  Stopped between two rows, if work is to stop.
  std::string write() {
    if (info_ == nullptr) refuse();
    attempt([](Writer& w) { w.write_head(); });
    for (row_ = 0; row_ < image_.height(); ++row_) {
      checkpoint(kOfByte * static_cast<std::uint64_t>(image_.width() * image_.channels()));
      attempt([](Writer& w) { png_write_row(w.png_, w.image_.row(w.row_)); });
    }
    attempt([](Writer& w) { png_write_end(w.png_, w.info_); });
    return std::move(out_.bytes);
  }

 private:
  [[nodiscard]] png_uint_32 width() const { return static_cast<png_uint_32>(image_.width()); }
  [[nodiscard]] png_uint_32 height() const { return static_cast<png_uint_32>(image_.height()); }

  void write_head() {
    constexpr int kBits = 8;
    png_set_write_fn(png_, &out_, append, nullptr);
    png_set_IHDR(png_, info_, width(), height(), kBits,
                 image_.channels() == 3 ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_GRAY,
                 PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_BASE, PNG_FILTER_TYPE_BASE);
    png_set_sRGB(png_, info_, PNG_sRGB_INTENT_PERCEPTUAL);
    png_write_info(png_, info_);
  }

  void attempt(void (*step)(Writer&)) {
    if (!is_done(step)) refuse();
  }
  bool is_done(void (*step)(Writer&)) {
    if (setjmp(png_jmpbuf(png_)) != 0) return false;
    step(*this);
    return true;
  }
  [[noreturn]] void refuse() const {
    throw ArgumentError(fmt::format("The picture of {} x {} pixels cannot be written as PNG: {}.",
                                    width(), height(),
                                    out_.why.empty() ? "memory is short" : out_.why.c_str()));
  }

  const Image& image_;
  Output out_;
  png_structp png_ = nullptr;
  png_infop info_ = nullptr;
  int row_ = 0;
};

}  // namespace

std::string write_png(const Image& image) {
  check_8_bit("write_png", image);
  return Writer(image).write();
}

}  // namespace armlet
