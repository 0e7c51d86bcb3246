#pragma once
// The part of a call that a message marks.

#include <cstddef>
#include <string_view>

namespace armlet {

// The whole call, the name of the function, or one of its arguments.
//
// An argument is named by its parameter, as the signature of the function that runs spells it:
// at("speed"). The name is resolved when the message is made; a message with a name that the
// signature does not have says so.
class CallPart {
 public:
  constexpr CallPart() = default;  // the whole call
  // The name of the function.
  [[nodiscard]] static constexpr CallPart callee() { return {nullptr, kCallee}; }
  // The first argument, whatever its name: of functions of one value, and of operators.
  [[nodiscard]] static constexpr CallPart first() { return operand(0); }
  // An argument by its index: operations of the virtual machine have no signature.
  [[nodiscard]] static constexpr CallPart operand(int index) { return {nullptr, index}; }
  // name  outlives the part.
  [[nodiscard]] static constexpr CallPart parameter(std::string_view name) {
    return {name.data(), static_cast<int>(name.size())};
  }

  [[nodiscard]] constexpr bool is_callee() const { return !is_named() && number_ == kCallee; }
  // Empty if the part is not a parameter by its name.
  [[nodiscard]] constexpr std::string_view parameter() const {
    return is_named() ? std::string_view(name_, static_cast<std::size_t>(number_))
                      : std::string_view();
  }
  // The index of an operand; -1: the part is none.
  [[nodiscard]] constexpr int operand() const { return is_named() || number_ < 0 ? -1 : number_; }

  constexpr bool operator==(const CallPart& other) const {
    return parameter() == other.parameter() && (is_named() || number_ == other.number_) &&
           is_named() == other.is_named();
  }

 private:
  static constexpr int kWhole = -1, kCallee = -2;
  constexpr CallPart(const char* name, int number) : name_(name), number_(number) {}
  [[nodiscard]] constexpr bool is_named() const { return name_ != nullptr; }

  // Two words, so that a part is passed in registers.
  const char* name_ = nullptr;  // null: no name
  int number_ = kWhole;         // the size of the name, or else an index
};

// The argument of a parameter: at("speed").
template <std::size_t N>
[[nodiscard]] consteval CallPart at(const char (&parameter)[N]) {
  return CallPart::parameter({parameter, N - 1});
}

// The name of a parameter as an argument of a template: check_word<"axis", kAxes>.
struct ParameterName {
  static constexpr std::size_t kMost = 24;
  char text[kMost] = {};
  std::size_t size = 0;

  template <std::size_t N>
  consteval ParameterName(const char (&name)[N]) : size(N - 1) {
    static_assert(N <= kMost);
    for (std::size_t i = 0; i < size; ++i) text[i] = name[i];
  }
};
template <ParameterName kName>
inline constexpr CallPart kPart = CallPart::parameter({kName.text, kName.size});

}  // namespace armlet
