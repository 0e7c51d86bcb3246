// Lines edited with libedit. The library is loaded only when a terminal needs it, so that other
// commands start sooner.

#include <histedit.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <clocale>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <utility>

#include "armlet/core/platform.hpp"
#include "console/console.hpp"
#include "prompt/line_source.hpp"

namespace armlet::cli {
namespace {

constexpr int kRemembered = 2000;       // entries of the history
constexpr std::size_t kMostShown = 60;  // choices in a list

struct EditLibrary {
  LoadedLibrary library{"libedit.so.2"};
  decltype(&::el_init) init = find<decltype(&::el_init)>("el_init");
  decltype(&::el_end) end = find<decltype(&::el_end)>("el_end");
  decltype(&::el_set) set = find<decltype(&::el_set)>("el_set");
  decltype(&::el_get) get = find<decltype(&::el_get)>("el_get");
  decltype(&::el_gets) gets = find<decltype(&::el_gets)>("el_gets");
  decltype(&::el_resize) resize = find<decltype(&::el_resize)>("el_resize");
  decltype(&::el_line) line = find<decltype(&::el_line)>("el_line");
  decltype(&::el_insertstr) insert = find<decltype(&::el_insertstr)>("el_insertstr");
  decltype(&::el_deletestr) remove = find<decltype(&::el_deletestr)>("el_deletestr");
  decltype(&::history_init) history_init = find<decltype(&::history_init)>("history_init");
  decltype(&::history_end) history_end = find<decltype(&::history_end)>("history_end");
  decltype(&::history) history = find<decltype(&::history)>("history");

  [[nodiscard]] bool is_whole() const {
    return init != nullptr && end != nullptr && set != nullptr && get != nullptr &&
           gets != nullptr && resize != nullptr && line != nullptr && insert != nullptr &&
           remove != nullptr && history_init != nullptr && history_end != nullptr &&
           history != nullptr;
  }

 private:
  template <class Function>
  Function find(const char* name) const {
    return reinterpret_cast<Function>(library.find(name));
  }
};

// Loads the library at the first call.
const EditLibrary& edit_library() {
  static const EditLibrary library;
  return library;
}

std::size_t characters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; }));
}

// The common prefix of all texts.
std::string common_start(const std::vector<std::string>& texts) {
  std::string start = texts.front();
  for (const std::string& text : texts) {
    const auto [a, b] = std::ranges::mismatch(start, text);
    start.erase(a, start.end());
  }
  while (!start.empty() && (static_cast<unsigned char>(start.back()) & 0xC0U) == 0x80U)
    start.pop_back();
  return start;
}

// The texts in columns, for a terminal with 80 characters per line.
std::string list_of(const std::vector<std::string>& texts) {
  std::size_t widest = 0;
  for (const std::string& text : texts) widest = std::max(widest, characters(text));
  const std::size_t columns = std::max<std::size_t>(1, 78 / (widest + 2));
  std::string out;
  for (std::size_t i = 0; i < std::min(texts.size(), kMostShown); ++i) {
    out += texts[i];
    const bool ends = i % columns == columns - 1 || i + 1 == std::min(texts.size(), kMostShown);
    out += ends ? std::string("\n") : std::string(widest + 2 - characters(texts[i]), ' ');
  }
  if (texts.size() > kMostShown)
    out += "... and " + std::to_string(texts.size() - kMostShown) + " more\n";
  return out;
}

// The codes that terminals send for keys that libedit does not bind, and their functions: Home and
// End of xterm, the Linux console, rxvt and tmux; arrows with Ctrl or Alt; Page Up and Down, which
// go to entries that begin like the line; keys without a function, which would insert characters.
struct Key {
  const char* sequence;
  const char* action;
};
constexpr Key kKeys[] = {
    {"\\e[H", "ed-move-to-beg"},
    {"\\eOH", "ed-move-to-beg"},
    {"\\e[1~", "ed-move-to-beg"},
    {"\\e[7~", "ed-move-to-beg"},
    {"\\e[1;5H", "ed-move-to-beg"},
    {"\\e[F", "ed-move-to-end"},
    {"\\eOF", "ed-move-to-end"},
    {"\\e[4~", "ed-move-to-end"},
    {"\\e[8~", "ed-move-to-end"},
    {"\\e[1;5F", "ed-move-to-end"},
    {"\\e[1;5C", "em-next-word"},
    {"\\e[1;3C", "em-next-word"},
    {"\\e[5C", "em-next-word"},
    {"\\eOc", "em-next-word"},
    {"\\e[1;5D", "ed-prev-word"},
    {"\\e[1;3D", "ed-prev-word"},
    {"\\e[5D", "ed-prev-word"},
    {"\\eOd", "ed-prev-word"},
    {"\\e[1;2C", "ed-next-char"},
    {"\\e[1;2D", "ed-prev-char"},
    {"\\e[1;5A", "ed-prev-history"},
    {"\\e[1;5B", "ed-next-history"},
    {"\\e[5~", "ed-search-prev-history"},
    {"\\e[6~", "ed-search-next-history"},
    {"\\e[3~", "ed-delete-next-char"},
    {"\\e[3;5~", "em-delete-next-word"},
    {"\\e[2~", "ed-ignore"},
    {"\\e[11~", "ed-ignore"},
    {"\\e[12~", "ed-ignore"},
    {"\\e[13~", "ed-ignore"},
    {"\\e[14~", "ed-ignore"},
    {"\\e[15~", "ed-ignore"},
    {"\\e[17~", "ed-ignore"},
    {"\\e[18~", "ed-ignore"},
    {"\\e[19~", "ed-ignore"},
    {"\\e[20~", "ed-ignore"},
    {"\\e[21~", "ed-ignore"},
    {"\\e[23~", "ed-ignore"},
    {"\\e[24~", "ed-ignore"},
    {"\\eOP", "ed-ignore"},
    {"\\eOQ", "ed-ignore"},
    {"\\eOR", "ed-ignore"},
    {"\\eOS", "ed-ignore"},
};

class EditedLines final : public LineSource {
 public:
  EditedLines(Completer complete, std::string history)
      : complete_(std::move(complete)), file_(std::move(history)) {
    // Lines are UTF-8, whatever the locale of the terminal is.
    if (std::setlocale(LC_CTYPE, "C.UTF-8") == nullptr) std::setlocale(LC_CTYPE, "");
    history_ = edit_.history_init();
    edit_.history(history_, &event_, H_SETSIZE, kRemembered);
    edit_.history(history_, &event_, H_SETUNIQUE, 1);
    if (!file_.empty()) edit_.history(history_, &event_, H_LOAD, file_.c_str());
    line_ = edit_.init("armlet", stdin, stdout, stderr);
    edit_.set(line_, EL_CLIENTDATA, this);
    edit_.set(line_, EL_PROMPT, &EditedLines::shown_prompt);
    edit_.set(line_, EL_EDITOR, "emacs");
    edit_.set(line_, EL_SIGNAL, 0);
    edit_.set(line_, EL_GETCFN, &EditedLines::next_character);
    edit_.set(line_, EL_HIST, edit_.history, history_);
    edit_.set(line_, EL_ADDFN, "armlet-complete", "complete the word", &EditedLines::on_tab);
    edit_.set(line_, EL_BIND, "^I", "armlet-complete", nullptr);
    edit_.set(line_, EL_BIND, "^R", "em-inc-search-prev", nullptr);
    for (const Key& key : kKeys) edit_.set(line_, EL_BIND, key.sequence, key.action, nullptr);
  }
  ~EditedLines() override {
    edit_.end(line_);
    edit_.history_end(history_);
  }
  EditedLines(const EditedLines&) = delete;
  EditedLines& operator=(const EditedLines&) = delete;

  std::optional<std::string> next(std::string_view prompt) override {
    prompt_ = prompt;
    edit_.resize(line_);
    int count = 0;
    const char* text = edit_.gets(line_, &count);
    if (interrupted()) {
      print_out("^C\n");
      static_cast<void>(finish_output());
      return std::nullopt;
    }
    if (text == nullptr || count <= 0) {
      print_out("\n");
      return std::nullopt;
    }
    std::string line(text, static_cast<std::size_t>(count));
    while (!line.empty() && (line.back() == '\n' || line.back() == '\r')) line.pop_back();
    return line;
  }

  void remember(const std::string& text) override {
    edit_.history(history_, &event_, H_ENTER, text.c_str());
    // Saved after each line: a session may end at any moment.
    if (!file_.empty()) edit_.history(history_, &event_, H_SAVE, file_.c_str());
  }

 private:
  static EditedLines& of(EditLine* line);
  static char* shown_prompt(EditLine* line);
  static int next_character(EditLine* line, wchar_t* character);
  static unsigned char on_tab(EditLine* line, int key);
  unsigned char complete();

  const EditLibrary& edit_ = edit_library();
  Completer complete_;
  std::string file_;
  std::string prompt_;
  HistEvent event_{};
  History* history_ = nullptr;
  EditLine* line_ = nullptr;
};

EditedLines& EditedLines::of(EditLine* line) {
  void* lines = nullptr;
  edit_library().get(line, EL_CLIENTDATA, &lines);
  return *static_cast<EditedLines*>(lines);
}
char* EditedLines::shown_prompt(EditLine* line) { return of(line).prompt_.data(); }
unsigned char EditedLines::on_tab(EditLine* line, int /*key*/) { return of(line).complete(); }

// A byte of the keyboard. Nullopt: the input has ended, or Ctrl-C was pressed.
std::optional<unsigned char> next_byte() {
  sigset_t interrupts;
  sigset_t before;
  sigemptyset(&interrupts);
  sigaddset(&interrupts, SIGINT);
  sigprocmask(SIG_BLOCK, &interrupts, &before);
  pollfd input{.fd = STDIN_FILENO, .events = POLLIN, .revents = 0};
  while (!interrupted() && ppoll(&input, 1, nullptr, &before) < 0 && errno == EINTR) {
  }
  sigprocmask(SIG_SETMASK, &before, nullptr);
  unsigned char byte = 0;
  if (interrupted() || read(STDIN_FILENO, &byte, 1) != 1) return std::nullopt;
  return byte;
}

// Decodes UTF-8; an invalid byte becomes a question mark.
int EditedLines::next_character(EditLine* /*line*/, wchar_t* character) {
  const auto first = next_byte();
  if (!first) return interrupted() ? -1 : 0;
  const int more = *first < 0xC0U ? 0 : *first < 0xE0U ? 1 : *first < 0xF0U ? 2 : 3;
  unsigned code = more == 0 ? *first : *first & (0x3FU >> static_cast<unsigned>(more));
  bool is_right = *first < 0x80U || more > 0;
  for (int i = 0; i < more; ++i) {
    const auto next = next_byte();
    if (!next) return interrupted() ? -1 : 0;
    is_right = is_right && (*next & 0xC0U) == 0x80U;
    code = code << 6U | (*next & 0x3FU);
  }
  *character = is_right ? static_cast<wchar_t>(code) : L'?';
  return 1;
}

unsigned char EditedLines::complete() {
  const LineInfo* info = edit_.line(line_);
  const std::string_view before(info->buffer,
                                static_cast<std::size_t>(info->cursor - info->buffer));
  const Choices choices = complete_(before);
  if (choices.texts.empty()) return CC_REFRESH_BEEP;
  const std::string written(before.substr(before.size() - choices.word_bytes));
  const std::string start = common_start(choices.texts);
  if (start.size() > written.size() || (choices.texts.size() == 1 && start != written)) {
    if (choices.word_bytes > 0) edit_.remove(line_, static_cast<int>(characters(written)));
    edit_.insert(line_, start.c_str());
    return CC_REFRESH;
  }
  if (choices.texts.size() == 1) return CC_REFRESH;
  print_out("\n" + list_of(choices.texts));
  static_cast<void>(finish_output());
  return CC_REDISPLAY;
}

}  // namespace

std::unique_ptr<LineSource> edited_lines(Completer complete, const std::string& history) {
  if (!edit_library().is_whole()) return nullptr;
  return std::make_unique<EditedLines>(std::move(complete), history);
}

}  // namespace armlet::cli
