#pragma once
// Host types, each declared by one expression:
//
//     engine.define(type<Valve>("Valve", "Lets water through.")
//                       .constructor("(width: length = 80mm)", &make_valve, "A closed one.")
//                       .assignable("width: length", &Valve::width, "Of its pipe.")
//                       .field("flow", &Valve::flow, "Through it, l/s.")
//                       .method("open(by: length?) -> Valve", &Valve::open, "Opens it."));
//
// Values of T are values of the language: `def` functions take them as const T&, or as const T* for
// optional parameters, and return them as T, std::vector<T> and Answer<T>. Programs can compare
// them if T has ==, and print them if T has `std::string text() const`. A program changes an
// assignable field by `v.width = 5mm`, which replaces the value of v by a changed copy.

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

// A type with its functions, for Engine::define.
class TypeDefinition {
 public:
  [[nodiscard]] const HostType& type() const { return kept_->type; }
  [[nodiscard]] std::span<const NativeFunction> functions() const { return kept_->functions; }
  // The mistakes in its texts, as clauses.
  [[nodiscard]] std::span<const std::string> mistakes() const { return kept_->mistakes; }
  [[nodiscard]] std::shared_ptr<const void> kept() const { return kept_; }

 protected:
  struct Texts {
    std::string signature;  // with the name before it
    std::string help;
    std::string example;
  };
  TypeDefinition(const HostType& in_cpp, std::string name, std::string help);

  // Adds the parameter of the value: "open(by: length?)" -> "open(valve: Valve, by: length?)"
  [[nodiscard]] std::string with_value(std::string_view signature) const;
  // The signature of the function that reads a field: "width: length" or "width" ->
  // "Valve.width(valve: Valve) -> length". The function that changes it has a similar one.
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

// A member of a base class of T, as a member of T.
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

  // Adds the function that makes a value and has the name of the type. Its parameters are, for
  // example, "(width: length)".
  template <class F>
  TypeOf& constructor(std::string_view parameters, F function, std::string help = "",
                      std::string example = "", const CallOptions& options = {}) {
    const std::string name(type().name);
    add({name + std::string(parameters) + " -> " + name, std::move(help), std::move(example)},
        std::move(function), options);
    return *this;
  }

  // Adds a field that programs can read, "width: length". Without a type it is double, int, bool,
  // string or double[], as in C++.
  template <class V, class C>
  TypeOf& field(std::string_view name, V C::*member, std::string help = "",
                std::string example = "") {
    static_assert(std::derived_from<T, C>);
    V T::*const of_type = member;
    add({getter(name, Given<std::remove_const_t<V>>::kKind), std::move(help), std::move(example)},
        reader(of_type), {});
    return *this;
  }
  // Adds a field that programs can read and change.
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

  // Adds a function of the value, `v.open(by: 5mm)`, or an operator whose left operand is the
  // value, "operator+(other: Valve) -> Valve". The function is a const member of T, or its first
  // parameter is a const T&. The signature does not contain this parameter.
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

  // Sets words for messages: "a valve", and the use of such a value.
  TypeOf& noun(std::string noun, std::string use = "") {
    changed().noun = keep(std::move(noun));
    changed().use = keep(std::move(use));
    return *this;
  }
  // Makes values handles: each stands for one thing, which has the name of the declared variable if
  // the constructor has a parameter `name: string`.
  TypeOf& handle() {
    changed().is_handle = true;
    return *this;
  }
  // Lets calls omit a first argument of this type.
  TypeOf& ambient() {
    changed().is_ambient = true;
    return *this;
  }
  // Makes each value a resource that only one task at a time may command (resource.hpp). The words
  // must outlive the engine.
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

// A declaration of the type `name` of the language, whose values are T in C++.
template <class T>
[[nodiscard]] TypeOf<T> type(std::string name, std::string help) {
  return TypeOf<T>(std::move(name), std::move(help));
}

}  // namespace armlet
