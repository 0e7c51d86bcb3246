#pragma once
// Native functions that the loops of map, filter, sort and similar functions use.

#include "armlet/interpreter/native.hpp"

namespace armlet::lang {

// (xs, ys) -> their common length; R0613 if they differ.
extern const NativeFunction kCommonLength;

// (xs, keys) -> the elements in the order of their keys; equal keys keep their order.
extern const NativeFunction kSortByInt;
extern const NativeFunction kSortByReal;
extern const NativeFunction kSortByText;

}  // namespace armlet::lang
