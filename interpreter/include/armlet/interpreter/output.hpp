#pragma once
// Where a program's output goes.

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>

namespace armlet {

// What writes a piece of text. Made of anything that can be called with one: it gives nothing, or
// a text that says why the piece could not be written, empty if it was. The program that prints
// then fails with that reason.
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
  // Why the text could not be written; empty: it was.
  [[nodiscard]] std::string operator()(std::string_view text) const { return write_(text); }

 private:
  std::function<std::string(std::string_view)> write_;
};

// As much of the beginning of a text as `most` bytes hold, ended where a character ends.
[[nodiscard]] inline std::string_view whole_characters(std::string_view text, std::uint64_t most) {
  if (text.size() <= most) return text;
  std::size_t end = most;
  while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) --end;
  return text.substr(0, end);
}

}  // namespace armlet
