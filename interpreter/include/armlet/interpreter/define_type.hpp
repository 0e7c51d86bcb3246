#pragma once
// Types of the host, each declared in one expression:
//
//     engine.define(type<Valve>("Valve", "Lets water through.")
//                       .constructor("(width: length = 80mm)", &make_valve, "A closed one.")
//                       .assignable("width: length", &Valve::width, "Of its pipe.")
//                       .field("flow", &Valve::flow, "Through it, l/s.")
//                       .method("open(by: length?) -> Valve", &Valve::open, "Opens it."));
//
// Values of T are values of the language: functions of `def` take them as const T& and const T*
// (of a parameter that may be left out) and give them as T, std::vector<T> and Answer<T>. They are
// compared where T has ==, and printed where T has `std::string text() const`. A program changes an
// assignable field by `v.width = 5mm`, which puts a changed copy where the value was.

#include <concepts>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "armlet/interpreter/binding/stored.hpp"
#include "armlet/interpreter/define.hpp"

namespace armlet {

// A type and its functions, for Engine::define.
class TypeDefinition {
 public:
  [[nodiscard]] const HostType& type() const { return kept_->type; }
  [[nodiscard]] std::span<const NativeFunction> functions() const { return kept_->functions; }
  // What is wrong with the texts, as clauses.
  [[nodiscard]] std::span<const std::string> mistakes() const { return kept_->mistakes; }
  [[nodiscard]] std::shared_ptr<const void> kept() const { return kept_; }

 protected:
  struct Texts {
    std::string signature;  // with the name in front
    std::string help;
    std::string example;
  };
  TypeDefinition(const HostType& in_cpp, std::string name, std::string help);

  // "open(by: length?)" -> "open(valve: Valve, by: length?)"
  [[nodiscard]] std::string with_value(std::string_view signature) const;
  // "width: length" or "width" -> "Valve.width(valve: Valve) -> length", and what changes it.
  [[nodiscard]] std::string getter(std::string_view field, const ValueKind& kind);
  [[nodiscard]] std::string setter(std::string_view field, const ValueKind& kind);
  [[nodiscard]] HostType& changed() { return kept_->type; }
  [[nodiscard]] std::string_view keep(std::string text);
  void mistake(std::string what) { kept_->mistakes.push_back(std::move(what)); }

  template <class F>
  void add(Texts texts, F function, const CallOptions& options) {
    if constexpr (std::is_pointer_v<F> || std::is_member_pointer_v<F>) {
      if (function == nullptr)
        return mistake("there is no function behind `" + texts.signature + '`');
    }
    auto closure = std::make_shared<const F>(std::move(function));
    const Thunk thunk(&typed::call_closure<F>, closure.get());
    kept_->closures.push_back(std::move(closure));
    const std::string_view signature = keep(std::move(texts.signature));
    const std::string_view help = keep(std::move(texts.help));
    kept_->functions.push_back(
        typed::row<F>(signature, help, keep(std::move(texts.example)), options, thunk));
  }

 private:
  [[nodiscard]] std::string type_of_field(std::string_view field, const ValueKind& kind);

  struct Kept {
    HostType type;
    std::vector<NativeFunction> functions;
    std::vector<std::string> mistakes;
    std::vector<std::unique_ptr<const std::string>> texts;
    std::vector<std::shared_ptr<const void>> closures;
  };
  std::shared_ptr<Kept> kept_ = std::make_shared<Kept>();  // shared with the engines
};

namespace typed {

// A member of a class that T derives from, as one of T.
template <class T, class F>
struct MemberOf {
  using Type = F;
};
template <class T, class R, class C, class... Parameters>
struct MemberOf<T, R (C::*)(Parameters...) const> {
  using Type = R (T::*)(Parameters...) const;
};
template <class T, class R, class C, class... Parameters>
struct MemberOf<T, R (C::*)(Parameters...) const noexcept> {
  using Type = R (T::*)(Parameters...) const noexcept;
};
template <class F>
inline constexpr bool kIsChanging = false;
template <class R, class C, class... Parameters>
inline constexpr bool kIsChanging<R (C::*)(Parameters...)> = true;
template <class R, class C, class... Parameters>
inline constexpr bool kIsChanging<R (C::*)(Parameters...) noexcept> = true;

template <class T, class Takes>
inline constexpr bool kTakesFirst = false;
template <class T, class... More>
inline constexpr bool kTakesFirst<T, std::tuple<const T&, More...>> = true;
template <class T, class... More>
inline constexpr bool kTakesFirst<T, std::tuple<T, More...>> = true;
template <class T, class... More>
inline constexpr bool kTakesFirst<T, std::tuple<Vm&, const T&, More...>> = true;

}  // namespace typed

template <class T>
class TypeOf : public TypeDefinition {
  static_assert(std::is_class_v<T> && std::is_move_constructible_v<T>);
  static_assert(alignof(T) <= 16, "values lie at multiples of 16 bytes");
  static_assert(kHostType<T> == nullptr, "kHostType names the type of these values already");

 public:
  TypeOf(std::string name, std::string help)
      : TypeDefinition(typed::kTypeInCpp<T>, std::move(name), std::move(help)) {}

  // The function that makes a value, which has the name of the type: its parameters are
  // "(width: length)".
  template <class F>
  TypeOf& constructor(std::string_view parameters, F function, std::string help = "",
                      std::string example = "", const CallOptions& options = {}) {
    const std::string name(type().name);
    add({name + std::string(parameters) + " -> " + name, std::move(help), std::move(example)},
        std::move(function), options);
    return *this;
  }

  // A field that programs read, "width: length"; without a type it is double, int, bool, string or
  // double[], as in C++.
  template <class V, class C>
  TypeOf& field(std::string_view name, V C::*member, std::string help = "",
                std::string example = "") {
    static_assert(std::derived_from<T, C>);
    V T::*const of_type = member;
    add({getter(name, Given<std::remove_const_t<V>>::kKind), std::move(help), std::move(example)},
        reader(of_type), {});
    return *this;
  }
  // One that they may change, too.
  template <class V, class C>
  TypeOf& assignable(std::string_view name, V C::*member, std::string help = "",
                     std::string example = "") {
    static_assert(std::copy_constructible<T> && !std::is_const_v<V>);
    using Part = typename typed::Stored<V>::Type;
    V T::*const of_type = member;
    const auto store = [of_type](const T& old, Part value) {
      T out = old;
      out.*of_type = typed::stored<V>(value);
      return out;
    };
    add({setter(name, Argument<Part>::kKind), help, example}, store, {});
    return field(name, member, std::move(help), std::move(example));
  }

  // A function of the value, `v.open(by: 5mm)`, or an operator, "operator+(other: Valve) ->
  // Valve", whose left side the value is: a const member of T, or what takes const T& first. The
  // signature leaves that parameter out.
  template <class F>
  TypeOf& method(std::string_view signature, F function, std::string help = "",
                 std::string example = "", const CallOptions& options = {}) {
    using Member = typename typed::MemberOf<T, F>::Type;
    static_assert(!typed::kIsChanging<F>, "values do not change: the member has to be const");
    static_assert(typed::kTakesFirst<T, typename typed::Shape<Member>::Takes>,
                  "a method takes const T& first");
    add({with_value(signature), std::move(help), std::move(example)}, Member(std::move(function)),
        options);
    return *this;
  }

  // For messages: "a valve", and what such a value does where it fits.
  TypeOf& noun(std::string noun, std::string use = "") {
    changed().noun = keep(std::move(noun));
    changed().use = keep(std::move(use));
    return *this;
  }
  // Values that name one thing each, which takes the name of its declaration where its constructor
  // has a parameter `name: string`.
  TypeOf& handle() {
    changed().is_handle = true;
    return *this;
  }
  // Calls may leave out a first argument of this type.
  TypeOf& ambient() {
    changed().is_ambient = true;
    return *this;
  }
  // Each is a resource that one task at a time may command (resource.hpp); the words outlive the
  // engine.
  TypeOf& exclusive(const ResourceWords& words) {
    changed().resource = &words;
    return *this;
  }

 private:
  template <class V>
  static auto reader(V T::*member) {
    return [member](const T& value) -> std::remove_const_t<V> { return value.*member; };
  }
};

// The type `name` of the language, whose values are T in C++.
template <class T>
[[nodiscard]] TypeOf<T> type(std::string name, std::string help) {
  return TypeOf<T>(std::move(name), std::move(help));
}

}  // namespace armlet
