#pragma once
// Pictures as values of programs: shared until they are changed, counted against the heap limit.

#include <concepts>
#include <memory>
#include <optional>
#include <string_view>
#include <utility>

#include "armlet/image/image.hpp"
#include "armlet/interpreter/work.hpp"
#include "messages/library_messages.hpp"
#include "session/bind.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// Pixels of one picture of a program at most.
inline constexpr std::int64_t kMostPixels = std::int64_t{1} << 24U;

// Pixels, and how they are counted; a copy that a host reads is not counted.
struct KeptPicture {
  Image image;
  std::optional<Scratch> counted{};
};
// What an `image` of the language holds.
struct PictureValue {
  std::shared_ptr<KeptPicture> kept;  // shared by values that have the same pixels
};

// Of pixels, bytes.
[[nodiscard]] std::uint64_t bytes_of(const Image& image);
// A new value; null: the heap limit was reached and the failure is set.
[[nodiscard]] Obj* new_picture(Vm& vm, Image image);

// "640 x 480", "RGB".
[[nodiscard]] std::string size_of(const Image& image);
[[nodiscard]] std::string_view kind_of(PixelKind kind);

// R0681: "this cannot be done with a picture: ...".
Failed fail_picture(Vm& vm, std::string_view clause, int parameter = -1, std::string fix = {});
// R0606 with the size of the picture.
Failed fail_outside(Vm& vm, const Image& image, std::int64_t x, std::int64_t y);

// Writes the picture into a file of the kind that its name says; else R0680 or R0681. `parameter`
// is that of the name.
Answer<void> save_picture(Vm& vm, const Image& image, std::string_view file, int parameter);

// f() of a function of pictures, after so many operations were counted; what it refuses is R0681.
template <class F>
auto with_pictures(Vm& vm, std::uint64_t operations, F f) -> Answer<decltype(f())> try {
  if (!charge_work(vm, operations)) return Failed{};
  return f();
} catch (const ArgumentError& error) {
  return fail_picture(vm, clause_of(error));
}

}  // namespace armlet::bind

namespace armlet {

template <>
struct Argument<const Image&> {
  static constexpr ValueKind kKind{ValueKind::Form::kHost, false, &bind::kImage};
  static const Image& read(Vm&, Slot slot) {
    return host_value<bind::PictureValue>(slot).kept->image;
  }
};
template <>
struct Given<Image> {
  static constexpr ValueKind kKind = Argument<const Image&>::kKind;
  static Signal leave(Vm& vm, Image image, Slot& slot) {
    return give(&slot, bind::new_picture(vm, std::move(image)));
  }
};

}  // namespace armlet
