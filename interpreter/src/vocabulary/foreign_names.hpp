#pragma once
// Names of other languages for functions of this one. Those for functions of a library are rows of
// its host (Engine::add_foreign_names), keywords are in base/foreign_words.hpp.

#include "armlet/interpreter/foreign_name.hpp"

namespace armlet::lang {

inline constexpr ForeignName kForeignNames[] = {
    {"WaitTime", "wait"},
    {"WaitUntil", "wait until"},
    {"sleep", "wait", "only the virtual clock passes"},
    {"delay", "wait", "only the virtual clock passes"},
    {"time.sleep", "wait"},
    {"println", "print"},
    {"printf", "print", "print takes f\"...\" for formatted text"},
    {"console.log", "print"},
    {"console.error", "print"},
    {"System.err.println", "print"},
    {"Serial.println", "print"},
    {"io.write", "print"},
    {"std.cout", "print"},
    {"cout", "print"},
    {"disp", "print"},
    {"echo", "print"},
    {"len", "length", "the length of a list is xs.length"},
    {"size", "length"},
    {"append", "push"},
    {"add", "push"},
    {"push_back", "push"},
    {"str", "string"},
    {"to_string", "string"},
    {"String.valueOf", "string"},
    {"num2str", "string"},
    {"char", "string", "a single character is a text of length 1"},
    {"charAt", "", "a single character of a text is s[i]"},
    {"get", "", "a value of a list is xs[i]"},
};

}  // namespace armlet::lang
