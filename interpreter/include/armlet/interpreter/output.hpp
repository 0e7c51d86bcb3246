#pragma once
// The destination of a program's output.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace armlet {

// Writes a text. It is made from any callable that takes a text and returns nothing, or returns a
// text: the reason why the output could not be written, or an empty text. A program whose output
// fails gets a failure with that reason.
class Output {
 public:
  Output() = default;
  template <class F>
  requires(!std::is_same_v<std::remove_cvref_t<F>, Output> &&
           std::is_invocable_v<F&, std::string_view>)
      Output(F write) {  // NOLINT(google-explicit-constructor): a lambda is what hosts write
    if constexpr (std::is_convertible_v<std::invoke_result_t<F&, std::string_view>, std::string>) {
      write_ = std::move(write);
    } else {
      write_ = [write = std::move(write)](std::string_view text) mutable {
        write(text);
        return std::string();
      };
    }
  }

  [[nodiscard]] explicit operator bool() const { return static_cast<bool>(write_); }
  // The reason why the text could not be written; empty if it was.
  [[nodiscard]] std::string operator()(std::string_view text) const { return write_(text); }

 private:
  std::function<std::string(std::string_view)> write_;
};

// The beginning of a text, of at most `most` bytes, that ends with a complete character.
[[nodiscard]] inline std::string_view whole_characters(std::string_view text, std::uint64_t most) {
  if (text.size() <= most) return text;
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end);
}

}  // namespace armlet
