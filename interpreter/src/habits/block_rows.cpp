// Blocks of other languages: a first line, lines in the middle, and a word or an indentation that
// ends them.

#include <array>

#include "habits/rows.hpp"

namespace armlet::lang {
namespace {

constexpr auto kBlocks = std::to_array<BlockHabit>({
    // RAPID, KRL
    {"FOR @ FROM $ TO $ STEP $ DO", "for ({1} in range({243:stepped})) {", "ENDFOR"},
    {"FOR @ FROM $ TO $ DO", "for ({1} in range({23:counted})) {", "ENDFOR"},
    {"FOR @ = $ TO $ STEP $", "for ({1} in range({243:stepped})) {", "ENDFOR"},
    {"FOR @ = $ TO $", "for ({1} in range({23:counted})) {", "ENDFOR"},
    {"WHILE $ DO", "while ({1:test}) {", "ENDWHILE|end"},
    {"LOOP", "while (true) {", "ENDLOOP"},
    {"REPEAT", "do {", "UNTIL"},
    {"IF $ THEN", "if ({1:test}) {", "ENDIF|end"},
    {"TEST $", "switch ({1}) {", "ENDTEST"},
    {"PROC @ ( * )", "fn {1}({2:parameters}) {", "ENDPROC"},
    {"FUNC @ @ ( * )", "fn {2}({3:parameters}) -> {1:type} {", "ENDFUNC"},
    {"LOCAL PROC @ ( * )", "fn {1}({2:parameters}) {", "ENDPROC"},
    {"MODULE *", "", "ENDMODULE"},
    {"DEFFCT @ @ ( * )", "fn {2}({3:parameters}) -> {1:type} {", "ENDFCT"},
    {"GLOBAL DEF @ ( * )", "fn {1}({2:parameters}) {", "END"},
    {"DEF @ ( * )", "fn {1}({2:parameters}) {", "END"},
    // Python, URScript
    {"if __name__ == $ :", "", ":"},
    {"def @ ( * ) -> @ :", "fn {1}({2:parameters}) -> {3:type} {", ":"},
    {"def @ ( * ) :", "fn {1}({2:parameters}) {", ":"},
    {"for @ , @ in enumerate ( $ ) :", "for ({1}, {2} in {3}) {", ":"},
    {"for @ , @ in $ . items ( ) :", "for ({1}, {2} in {3}) {", ":"},
    {"for @ in range ( len ( $ ) ) :", "for ({1} in range({2:operand}.length)) {", ":"},
    {"for @ in $ :", "for ({1} in {2}) {", ":"},
    {"while 1 :", "while (true) {", ":"},
    {"while $ :", "while ({1:test}) {", ":"},
    {"if $ :", "if ({1:test}) {", ":"},
    {"try :", "try {", ":"},
    // Lua
    {"local function @ ( * )", "fn {1}({2:parameters}) {", "end"},
    // MATLAB
    {"function @ = @ ( * )", "fn {2}({3:parameters}) {", "end", true},
    {"function @ ( * )", "fn {1}({2:parameters}) {", "end"},
    {"for @ = $ : $ : $", "for ({1} in range({234:stepped})) {", "end"},
    {"for @ = $ : $", "for ({1} in range({23:counted})) {", "end"},
    {"for @ = $", "for ({1} in {2}) {", "end"},
    {"while 1", "while (true) {", "end"},
    {"while $", "while ({1:test}) {", "end|ENDWHILE"},
    {"if $", "if ({1:test}) {", "end"},
    {"switch $", "switch ({1}) {", "end|ENDSWITCH"},
    {"try", "try {", "end"},
    // C
    {"int main ( * ) {", "", "}"},
    {"void main ( * ) {", "", "}"},
});

constexpr auto kMiddles = std::to_array<Habit>({
    {"ELSE", "} else {", ""},
    {"else :", "} else {", ""},
    {"ELSEIF $ THEN", "} else if ({1:test}) {", ""},
    {"else if $ then", "} else if ({1:test}) {", ""},
    {"elseif $", "} else if ({1:test}) {", ""},
    {"elif $ :", "} else if ({1:test}) {", ""},
    {"else if $ :", "} else if ({1:test}) {", ""},
    {"except :", "} catch (e) {", ""},
    {"except Exception :", "} catch (e) {", ""},
    {"except @ :", "} catch (e) { if (e.kind != \"{1:kind}\") throw e", ""},
    {"except Exception as @ :", "} catch ({1}) {", ""},
    {"except @ as @ :", "} catch ({2}) { if ({2}.kind != \"{1:kind}\") throw {2}", ""},
    {"finally :", "} finally {", ""},
    {"catch @", "} catch ({1}) {", ""},
    {"catch", "} catch (e) {", ""},
    {"CASE * :", "case {1}:", ""},
    {"CASE *", "case {1}:", ""},
    {"DEFAULT :", "default:", ""},
    {"DEFAULT", "default:", ""},
    {"otherwise", "default:", ""},
});

constexpr auto kEnds = std::to_array<Habit>({
    {"UNTIL $", "} while (!({1:test}))", ""},
    {"END @", "}", ""},
    {"@", "}", ""},
    {"\\}", "}", ""},
});

}  // namespace

std::span<const BlockHabit> block_habits() { return kBlocks; }
std::span<const Habit> middle_habits() { return kMiddles; }
std::span<const Habit> end_habits() { return kEnds; }

}  // namespace armlet::lang
