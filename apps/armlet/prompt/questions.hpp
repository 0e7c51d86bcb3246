#pragma once
// Questions at the prompt: pages of the library and names of the session.

#include <optional>
#include <string_view>

namespace armlet::cli {

class Prompt;

// Prints a line at once.
void say(std::string_view text);
[[nodiscard]] std::string_view trimmed(std::string_view text);  // without spaces around it

// Shows a name of the session with its `///`, or a page of the library; with `all` after the name
// every form of it. False: there is none.
bool show_page(Prompt& prompt, std::string_view name);
// Lists the pages about words; with `all` after them every page.
bool search_pages(std::string_view words);

// The page that a line asks for which is neither a command nor a program: `help moveL`,
// `help(moveL)`, `print`. An empty name: `help` and `help()` ask for the commands.
[[nodiscard]] std::optional<std::string_view> page_question(std::string_view line);
// Whether the first word of a line is a name of the session, so that the line is a program.
[[nodiscard]] bool is_declared(Prompt& prompt, std::string_view line);
bool show_asked_page(Prompt& prompt, std::string_view line, std::string_view name);

}  // namespace armlet::cli
