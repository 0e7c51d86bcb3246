#pragma once
// Native functions of the virtual machine that the compiler inserts into programs. The checker and
// the compiler must not depend on the virtual machine, so the Registry passes them the functions.

#include "armlet/interpreter/native.hpp"

namespace armlet::lang {

struct LanguageFunctions {
  const NativeFunction* print;  // (text: string)
  // These return lists that may have elements without a value, which is checked when an element is
  // read.
  const NativeFunction* filled;  // `new S[n]` of a struct whose fields all have defaults
  const NativeFunction* last;    // `xs.last`

  // ---- `record` and its tables
  // (sample: fn() -> row, period: time) -> table: takes the first sample and starts the recording.
  const NativeFunction* start_recording;
  const NativeFunction* end_recording;  // (table): takes the last sample and stops the recording
  const NativeFunction* table_column;   // (table, column: int) -> a list
  const NativeFunction* table_rows;     // (table) -> row[]
  const NativeFunction* table_length;   // (table) -> int

  // ---- loops over lists
  const NativeFunction* common_length;  // (xs, ys) -> their common length; R0613 if they differ
  // (xs, keys) -> the elements in the order of their keys; elements with equal keys keep their
  // order.
  const NativeFunction* sort_by_int;
  const NativeFunction* sort_by_real;
  const NativeFunction* sort_by_text;
};

}  // namespace armlet::lang
