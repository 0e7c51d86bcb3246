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
#include "values/bind.hpp"
#include "values/values.hpp"

namespace armlet::bind {

// The most pixels of one picture of a program.
inline constexpr std::int64_t kMostPixels = std::int64_t{1} << 24U;

// Pixels, and their charge against the heap limit; a copy for a host is not charged.
struct KeptPicture {
  Image image;
  std::optional<Scratch> counted{};
};
// The value of an `image` of the language.
struct PictureValue {
  std::shared_ptr<KeptPicture> kept;  // shared by values with the same pixels
};

// The memory of the pixels, bytes.
[[nodiscard]] std::uint64_t bytes_of(const Image& image);
// A new value; null: the heap limit was reached, and the failure is set.
[[nodiscard]] Obj* new_picture(Vm& vm, Image image);

// "640 x 480", "RGB".
[[nodiscard]] std::string size_of(const Image& image);
[[nodiscard]] std::string_view kind_of(PixelKind kind);

// R0681: "this cannot be done with a picture: ...".
Failed fail_picture(Vm& vm, std::string_view clause, CallPart part = {}, std::string fix = {});
// R0606 with the size of the picture.
Failed fail_outside(Vm& vm, const Image& image, std::int64_t x, std::int64_t y);

// Runs f() after charging this number of operations; its refusals are R0681.
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
