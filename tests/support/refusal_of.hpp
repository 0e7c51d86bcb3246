// What a call says when it refuses what it is asked.
#pragma once

#include <string>

#include "armlet/core/error.hpp"

namespace armlet {

// The words of the ArgumentError that `action` throws.
template <class Action>
std::string refusal_of(Action action) {
  try {
    action();
  } catch (const ArgumentError& error) {
    return error.what();
  }
  return "nothing was thrown";
}

}  // namespace armlet
