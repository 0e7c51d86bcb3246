#pragma once
// The functions behind `record` and its tables. The checker calls them; programs cannot name them.

#include "armlet/interpreter/native.hpp"

namespace armlet::lang {

// (sample: fn() -> row, period: time) -> table: takes the first sample and goes on.
extern const NativeFunction kStartRecording;
// (table): takes the last sample and stops.
extern const NativeFunction kEndRecording;
// (table, column: int) -> a list
extern const NativeFunction kTableColumn;
// (table) -> row[]
extern const NativeFunction kTableRows;
// (table) -> int
extern const NativeFunction kTableLength;

}  // namespace armlet::lang
