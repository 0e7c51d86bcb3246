#pragma once
// Units of numbers whose type has none, as the check before the run has determined
// them. It writes them into text parameters such as valueUnits: "rad/s,m/s",
// "@rad/s|m/s|arm" for all joints of an arm and "@rad/s|m/s|arm#2" for one
// (bind::dims_by_joint).

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "armlet/cell/cell.hpp"
#include "armlet/stdlib/laboratory_rows.hpp"

namespace armlet::bind {

[[nodiscard]] std::vector<LabNumber> numbers_in(std::string_view units);

// The dimensions; those of joints follow from the joints of the robots. Empty: not all are known.
[[nodiscard]] std::vector<Dim> dims_of(std::span<const LabNumber> numbers, const Cell& cell);

// The names of the units in SI, one for each of `count` numbers; a single unit applies to all.
// Empty: not all are known.
[[nodiscard]] std::vector<std::string> units_of(std::string_view units, std::size_t count,
                                                const Cell& cell);

// The part for column `k` of "s;rad/s,m/s", the units of a table.
[[nodiscard]] std::string_view part_of(std::string_view units, std::size_t k);

}  // namespace armlet::bind
