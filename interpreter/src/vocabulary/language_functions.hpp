#pragma once
// Functions of the machine that the checker and the compiler put into programs, which cannot name
// them. Whoever makes a Registry gives it these.

#include "armlet/interpreter/native.hpp"

namespace armlet::lang {

struct LanguageFunctions {
  const NativeFunction* print;  // (text: string)
  // These hand on lists with elements that are not set: they look themselves where they read one.
  const NativeFunction* filled;  // `new S[n]` of a struct whose fields all have defaults
  const NativeFunction* last;    // `xs.last`

  // ---- `record` and its tables
  // (sample: fn() -> row, period: time) -> table: takes the first sample and goes on.
  const NativeFunction* start_recording;
  const NativeFunction* end_recording;  // (table): takes the last sample and stops.
  const NativeFunction* table_column;   // (table, column: int) -> a list
  const NativeFunction* table_rows;     // (table) -> row[]
  const NativeFunction* table_length;   // (table) -> int

  // ---- loops over lists
  const NativeFunction* common_length;  // (xs, ys) -> their common length; R0613 if they differ.
  // (xs, keys) -> the elements in the order of their keys; equal keys keep their order.
  const NativeFunction* sort_by_int;
  const NativeFunction* sort_by_real;
  const NativeFunction* sort_by_text;
};

}  // namespace armlet::lang
