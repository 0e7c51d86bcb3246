#pragma once
// What the fuzzing targets share.

#include <string>

#include "armlet/stdlib/install.hpp"
#include "armlet/stdlib/session.hpp"
#include "entry.hpp"

namespace armlet::fuzz {

// A session with a scara and the command's world, small limits, and an end of time after a minute.
SessionOptions small_session();

// Shows every message in both forms.
void show_all(const Session& session);

// Ends the process if a promise is broken, as a crash does.
void demand(bool kept, const char* promise);

std::string text_of(const std::uint8_t* data, std::size_t size);

}  // namespace armlet::fuzz
