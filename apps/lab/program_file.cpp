#include "program_file.hpp"

#include <fmt/format.h>

#include <utility>

#include "laboratory_state.hpp"

namespace armlet::lab {
namespace {

std::string with_plain_ends(std::string_view text) {
  std::string out;
  out.reserve(text.size());
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\r' || i + 1 == text.size() || text[i + 1] != '\n') out += text[i];
  }
  return out;
}

// The text with the line ends of the file, since pages send only "\n".
std::string with_ends_of(std::string_view file, const std::string& text) {
  if (file.find("\r\n") == std::string_view::npos) return text;
  std::string out;
  for (const char c : with_plain_ends(text)) {
    if (c == '\n') out += '\r';
    out += c;
  }
  return out;
}

}  // namespace

bool is_same_program(std::string_view a, std::string_view b) {
  return a == b || with_plain_ends(a) == with_plain_ends(b);
}

void Laboratory::State::look_at_file() {
  if (!options.program_file.read) return;
  Result<std::string> now = options.program_file.read();
  if (!now.ok()) {
    // A file that cannot be read at the moment counts as unchanged.
    if (now.error().code != "missing" || !text.document.exists) return;
    text.document.exists = false;
    ++versions.document;
    return;
  }
  if (text.document.exists && *now == text.document.text) return;
  const bool has_edits = !text.document.exists || !is_same_program(text.now, text.document.text);
  text.document = {.text = *std::move(now), .exists = true, .is_changed = false};
  ++versions.document;
  if (is_same_program(text.now, text.document.text)) return;
  if (has_edits) {
    text.document.is_changed = true;
    return;
  }
  text.from = 0;
  take_text(text.document.text, text.version + 1, true);
}

void Laboratory::State::handle(Page& page, Seq seq, const SaveText& save) {
  if (!has_control(page, seq)) return;
  if (!options.program_file.write)
    return refuse(page, seq, "refused", "This laboratory has no file that could be written.");
  look_at_file();
  if (text.document.is_changed && !save.replaces) {
    return refuse(
        page, seq, "changed",
        fmt::format("{} was changed by another program, and has not been written.", options.file));
  }
  std::string written = with_ends_of(text.document.text, text.now);
  if (const std::optional<Error> why = options.program_file.write(written)) {
    return refuse(page, seq, "refused",
                  fmt::format("{} cannot be written: {}.", options.file, why->message));
  }
  text.document = {.text = std::move(written), .exists = true, .is_changed = false};
  ++versions.document;
  pages.answer(page, write_saved(seq));
}

}  // namespace armlet::lab
