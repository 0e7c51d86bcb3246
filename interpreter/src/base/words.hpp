#pragma once
// The keywords of the language, one row each, in the order of grammar/RbtLexer.g4 (language
// reference, section 3). Used for the ends of statements, for the continuation of the parser after
// a mistake, for messages, for the rules of names, for documents, and for the dictionary of the
// fuzzer.

#include <algorithm>
#include <array>
#include <cstdint>
#include <string_view>

namespace armlet::lang {

enum class WordKind : std::uint8_t {
  kReserved,  // never a name
  kType,      // never a name; a type
  kTruth,     // never a name; a value
  kSoft,      // a name everywhere except where the parser expects the word
};

struct Word {
  std::string_view text;
  WordKind kind = WordKind::kReserved;
  bool same_token = false;  // the grammar treats it as the word above
  bool starts = false;      // a statement may begin with it
  bool resumes = false;     // after a mistake the parser continues with it at the start of a line
  bool has_parts = false;   // its statement has a header, a body or its own name
  bool has_header = false;  // the parentheses after it are a header
  bool has_condition = false;     // the header is a bool
  bool needs_block = false;       // its statement is not complete before a block in braces
  bool takes_brace = false;       // a `{` on the next line belongs to its statement
  bool follows_block = false;     // continues a statement after the } of its block
  bool goes_on = false;           // a line that begins with it continues the statement above
  bool ends = false;              // a statement may end with it
  std::string_view wants{};       // the part that has to follow it, if there is only one
  std::string_view belongs_to{};  // the statement that it is used in, if there is only one
};

// clang-format off
inline constexpr Word kWordRows[] = {
    {.text = "let", .starts = true, .resumes = true, .has_parts = true, .wants = "a name"},
    {.text = "var", .starts = true, .resumes = true, .has_parts = true, .wants = "a name"},
    {.text = "fn", .starts = true, .has_parts = true, .needs_block = true, .takes_brace = true, .wants = "a name"},
    {.text = "struct", .starts = true, .resumes = true, .has_parts = true, .needs_block = true, .takes_brace = true,
     .wants = "a name"},
    {.text = "enum", .starts = true, .resumes = true, .has_parts = true, .needs_block = true, .takes_brace = true,
     .wants = "a name"},
    {.text = "import", .starts = true, .resumes = true, .wants = "the name of a file"},
    {.text = "final", .starts = true, .resumes = true, .wants = "a type"},
    {.text = "void", .starts = true, .needs_block = true, .takes_brace = true},
    {.text = "new", .wants = "a type"},
    {.text = "if", .starts = true, .resumes = true, .has_parts = true, .has_header = true, .has_condition = true},
    {.text = "else", .follows_block = true, .wants = "a statement", .belongs_to = "`else` follows the body of an `if`"},
    {.text = "while", .starts = true, .resumes = true, .has_parts = true, .has_header = true, .has_condition = true,
     .follows_block = true},
    {.text = "do", .starts = true, .has_parts = true, .wants = "a block in braces"},
    {.text = "for", .starts = true, .resumes = true, .has_parts = true, .has_header = true},
    {.text = "in", .goes_on = true, .wants = "a value"},
    {.text = "switch", .starts = true, .resumes = true, .has_parts = true, .has_header = true, .needs_block = true},
    {.text = "case", .wants = "a value", .belongs_to = "it stands directly inside a `switch`"},
    {.text = "default", .belongs_to = "it stands directly inside a `switch`"},
    {.text = "break", .starts = true, .ends = true},
    {.text = "continue", .starts = true, .ends = true},
    {.text = "return", .starts = true, .resumes = true, .ends = true},
    {.text = "try", .starts = true, .resumes = true, .has_parts = true, .needs_block = true, .wants = "a block in braces"},
    {.text = "catch", .has_header = true, .follows_block = true, .goes_on = true,
     .belongs_to = "it follows the block of a `try`"},
    {.text = "finally", .follows_block = true, .goes_on = true, .wants = "a block in braces",
     .belongs_to = "it follows the block of a `try`"},
    {.text = "throw", .starts = true, .wants = "a value"},
    {.text = "retry", .starts = true, .ends = true},
    {.text = "parallel", .starts = true, .resumes = true, .has_parts = true, .wants = "a block in braces"},
    {.text = "when", .starts = true, .has_parts = true, .has_header = true, .has_condition = true, .needs_block = true},
    {.text = "every", .starts = true, .has_parts = true, .has_header = true, .needs_block = true},
    {.text = "wait", .starts = true, .wants = "a value"},
    {.text = "until", .goes_on = true, .wants = "a value"},
    {.text = "with", .starts = true, .has_parts = true, .needs_block = true, .takes_brace = true},
    {.text = "true", .kind = WordKind::kTruth, .ends = true},
    {.text = "false", .kind = WordKind::kTruth, .ends = true},
    {.text = "int", .kind = WordKind::kType, .ends = true},
    {.text = "long", .kind = WordKind::kType, .same_token = true},
    {.text = "double", .kind = WordKind::kType, .ends = true},
    {.text = "float", .kind = WordKind::kType, .same_token = true},
    {.text = "bool", .kind = WordKind::kType, .ends = true},
    {.text = "boolean", .kind = WordKind::kType, .same_token = true},
    {.text = "test", .kind = WordKind::kSoft, .takes_brace = true, .ends = true},
    {.text = "record", .kind = WordKind::kSoft, .takes_brace = true, .ends = true},
    {.text = "path", .kind = WordKind::kSoft, .takes_brace = true, .ends = true, .wants = "a block in braces"},
    {.text = "as", .kind = WordKind::kSoft, .goes_on = true, .ends = true, .wants = "a name"},
};
// clang-format on

[[nodiscard]] constexpr bool is_reserved(const Word& word) { return word.kind != WordKind::kSoft; }

// The row of a keyword; null if the text is none.
[[nodiscard]] constexpr const Word* find_word(std::string_view text) {
  const Word* found = std::ranges::find(kWordRows, text, &Word::text);
  return found == std::end(kWordRows) ? nullptr : found;
}

[[nodiscard]] inline bool is_reserved_word(std::string_view text) {
  const Word* word = find_word(text);
  return word != nullptr && is_reserved(*word);
}

// Tokens of keywords are numbered from 1 in the order of the rows; syntax_words_test.cpp checks
// this.
inline constexpr std::size_t kWordTokens =
    1 + static_cast<std::size_t>(std::ranges::count(kWordRows, false, &Word::same_token));

inline constexpr auto kWordOfToken = [] {
  std::array<Word, kWordTokens> rows{};
  std::size_t token = 0;
  for (const Word& word : kWordRows) {
    if (!word.same_token) rows[++token] = word;
  }
  return rows;
}();

// The row of a kind of token; a row without properties if the token is no keyword.
[[nodiscard]] constexpr const Word& word_of(std::uint16_t token) {
  return kWordOfToken[token < kWordTokens ? token : 0];
}

// Whether a byte can be part of a name. Letters beyond ASCII consist of such bytes.
[[nodiscard]] inline bool is_word_character(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
         static_cast<unsigned char>(c) >= 0x80U;
}

}  // namespace armlet::lang
