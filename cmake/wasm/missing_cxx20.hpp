#pragma once
#pragma GCC system_header
// What emscripten's C++ library (libc++ 13) still lacks of C++20 and this project uses: algorithms
// of ranges, std::bit_cast, and text to and from floating-point numbers. It is included in front of
// every source by the WebAssembly build alone; a library that has these makes it empty.

// clang 14 breaks down where it compiles an argument that a consteval constructor makes, for
// WebAssembly. What is wrong with one is still found by every other build.
#if defined(__wasm__) && defined(__clang_major__) && __clang_major__ < 15
#define consteval constexpr
// As a constexpr constructor it would look at its format whenever it runs.
#define FMT_CONSTEVAL
#endif

#if __cplusplus >= 202002L && __has_include(<version>)
#include <version>
#if defined(_LIBCPP_VERSION) && _LIBCPP_VERSION < 15000

#include <algorithm>
#include <charconv>
#include <functional>
#include <iterator>
#include <type_traits>
#include <utility>

#include "missing_charconv.hpp"
#include "missing_sorting.hpp"

namespace std {

template <class To, class From>
constexpr To bit_cast(const From& from) noexcept {
  static_assert(sizeof(To) == sizeof(From));
  return __builtin_bit_cast(To, from);
}

namespace ranges {
namespace missing {

// A predicate of one element, and an order of two, seen through a projection.
template <class F, class Proj>
constexpr auto seen(F& f, Proj& proj) {
  return [&f, &proj](auto&& item) -> bool {
    return std::invoke(f, std::invoke(proj, std::forward<decltype(item)>(item)));
  };
}
template <class Less, class Proj>
constexpr auto order(Less& less, Proj& proj) {
  return [&less, &proj](auto&& a, auto&& b) -> bool {
    return std::invoke(less, std::invoke(proj, std::forward<decltype(a)>(a)),
                       std::invoke(proj, std::forward<decltype(b)>(b)));
  };
}
template <class Out>
struct OutResult {
  Out out;
};
template <class It>
struct MinMaxResult {
  It min, max;
};

}  // namespace missing

// Each takes a range; the forms with two iterators are not used here.
// `equal` and `less` in the macros are those of this namespace.
#define ARMLET_WITH_PREDICATE(name)                                                             \
  inline constexpr auto name = [](auto&& range, auto predicate, auto... proj) constexpr {       \
    auto projection = missing::projection_of(proj...);                                          \
    return std::name(std::begin(range), std::end(range), missing::seen(predicate, projection)); \
  }
#define ARMLET_WITH_ORDER(name)                                                         \
  struct name##_fn {                                                                    \
    template <class R, class Less = ranges::less, class Proj = identity>                \
    constexpr auto operator()(R&& range, Less less = {}, Proj proj = {}) const {        \
      return std::name(std::begin(range), std::end(range), missing::order(less, proj)); \
    }                                                                                   \
  };                                                                                    \
  inline constexpr name##_fn name {}

namespace missing {
constexpr identity projection_of() { return {}; }
template <class Proj>
constexpr Proj projection_of(Proj proj) {
  return proj;
}
}  // namespace missing

ARMLET_WITH_PREDICATE(all_of);
ARMLET_WITH_PREDICATE(any_of);
ARMLET_WITH_PREDICATE(none_of);
ARMLET_WITH_PREDICATE(find_if);
ARMLET_WITH_PREDICATE(find_if_not);
ARMLET_WITH_PREDICATE(count_if);
ARMLET_WITH_ORDER(is_sorted);
ARMLET_WITH_ORDER(max_element);
ARMLET_WITH_ORDER(min_element);
#undef ARMLET_WITH_PREDICATE
#undef ARMLET_WITH_ORDER

struct sort_fn {
  template <class R, class Less = ranges::less, class Proj = identity>
  constexpr void operator()(R&& range, Less less = {}, Proj proj = {}) const {
    missing::sort(std::begin(range), std::end(range), missing::order(less, proj));
  }
};
inline constexpr sort_fn sort{};
inline constexpr sort_fn stable_sort{};

struct minmax_element_fn {
  template <class R, class Less = ranges::less, class Proj = identity>
  constexpr auto operator()(R&& range, Less less = {}, Proj proj = {}) const {
    const auto [min, max] =
        std::minmax_element(std::begin(range), std::end(range), missing::order(less, proj));
    return missing::MinMaxResult<std::remove_const_t<decltype(min)>>{min, max};
  }
};
inline constexpr minmax_element_fn minmax_element{};

struct find_fn {
  template <class R, class T, class Proj = identity>
  constexpr auto operator()(R&& range, const T& value, Proj proj = {}) const {
    auto at = std::begin(range);
    const auto end = std::end(range);
    while (at != end && !(std::invoke(proj, *at) == value)) ++at;
    return at;
  }
};
inline constexpr find_fn find{};

struct count_fn {
  template <class R, class T, class Proj = identity>
  constexpr std::ptrdiff_t operator()(R&& range, const T& value, Proj proj = {}) const {
    std::ptrdiff_t number = 0;
    for (auto&& item : range) number += std::invoke(proj, item) == value ? 1 : 0;
    return number;
  }
};
inline constexpr count_fn count{};

struct lower_bound_fn {
  template <class R, class T, class Less = ranges::less, class Proj = identity>
  constexpr auto operator()(R&& range, const T& value, Less less = {}, Proj proj = {}) const {
    return std::partition_point(std::begin(range), std::end(range), [&](auto&& item) -> bool {
      return std::invoke(less, std::invoke(proj, item), value);
    });
  }
};
inline constexpr lower_bound_fn lower_bound{};

struct upper_bound_fn {
  template <class R, class T, class Less = ranges::less, class Proj = identity>
  constexpr auto operator()(R&& range, const T& value, Less less = {}, Proj proj = {}) const {
    return std::partition_point(std::begin(range), std::end(range), [&](auto&& item) -> bool {
      return !std::invoke(less, value, std::invoke(proj, item));
    });
  }
};
inline constexpr upper_bound_fn upper_bound{};

struct binary_search_fn {
  template <class R, class T, class Less = ranges::less, class Proj = identity>
  constexpr bool operator()(R&& range, const T& value, Less less = {}, Proj proj = {}) const {
    const auto at = lower_bound(range, value, less, proj);
    return at != std::end(range) && !std::invoke(less, value, std::invoke(proj, *at));
  }
};
inline constexpr binary_search_fn binary_search{};

struct equal_fn {
  template <class A, class B, class Same = ranges::equal_to, class ProjA = identity,
            class ProjB = identity>
  constexpr bool operator()(A&& a, B&& b, Same same = {}, ProjA proj_a = {},
                            ProjB proj_b = {}) const {
    return std::equal(std::begin(a), std::end(a), std::begin(b), std::end(b),
                      [&](auto&& one, auto&& other) -> bool {
                        return std::invoke(same, std::invoke(proj_a, one),
                                           std::invoke(proj_b, other));
                      });
  }
};
inline constexpr equal_fn equal{};

struct for_each_fn {
  template <class R, class F>
  constexpr void operator()(R&& range, F f) const {
    for (auto&& item : range) std::invoke(f, std::forward<decltype(item)>(item));
  }
};
inline constexpr for_each_fn for_each{};

struct copy_fn {
  template <class R, class Out>
  constexpr missing::OutResult<Out> operator()(R&& range, Out out) const {
    return {std::copy(std::begin(range), std::end(range), std::move(out))};
  }
};
inline constexpr copy_fn copy{};

struct move_fn {
  template <class R, class Out>
  constexpr missing::OutResult<Out> operator()(R&& range, Out out) const {
    return {std::move(std::begin(range), std::end(range), std::move(out))};
  }
};
inline constexpr move_fn move{};

struct transform_fn {
  template <class R, class Out, class F, class Proj = identity>
  constexpr missing::OutResult<Out> operator()(R&& range, Out out, F f, Proj proj = {}) const {
    return {std::transform(std::begin(range), std::end(range), std::move(out),
                           [&](auto&& item) { return std::invoke(f, std::invoke(proj, item)); })};
  }
};
inline constexpr transform_fn transform{};

struct reverse_fn {
  template <class R>
  constexpr void operator()(R&& range) const {
    std::reverse(std::begin(range), std::end(range));
  }
};
inline constexpr reverse_fn reverse{};

}  // namespace ranges
}  // namespace std

#endif
#endif
