#pragma once

#include "editor/facts.hpp"

namespace armlet::lang {

// The symbol that the name at a byte of the main text refers to; null: none of the program.
[[nodiscard]] const Symbol* symbol_at(const Facts& facts, std::uint32_t at);

}  // namespace armlet::lang
