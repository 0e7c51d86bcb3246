// Values of other languages, anywhere in a line.

#include <array>

#include "habits/rows.hpp"

namespace armlet::lang {
namespace {

constexpr std::string_view kFromZero = "indexes stand in square brackets and count from 0";
constexpr std::string_view kNoNull = "every variable has a value of its type from the start";
constexpr std::string_view kNamedSignals = "signals have names";

constexpr auto kValues = std::to_array<Habit>({
    // words and marks
    {"~=", "!=", ""},
    {"\\~", "!", ""},
    {"^AND", "&&", ""},
    {"^OR", "||", ""},
    {"^NOT", "!", ""},
    {"^MOD", "%", ""},
    {"^DIV", "/", ""},
    {"^TRUE", "true", ""},
    {"^FALSE", "false", ""},
    {"^True", "true", ""},
    {"^False", "false", ""},
    // Python
    {"[ $ for @ in $ if $ ]", "map(filter({3}, fn({2}) => {4}), fn({2}) => {1})", ""},
    {"[ $ for @ in $ ]", "map({3}, fn({2}) => {1})", ""},
    {"$ if $ else $", "{2} ? {1} : {3}", ""},
    {"= { $ : * }", "= [{1}: {2}]", "a map stands in square brackets"},
    {"in enumerate ( $ )", "in {1}", ""},
    {"if ( $ not in $ )", "if (!contains({2}, {1}))", ""},
    {"if ( $ in $ )", "if (contains({2}, {1}))", ""},
    {"$ is not None", kNoSuchThing, kNoNull},
    {"$ is None", kNoSuchThing, kNoNull},
    {"np . array ( [ [ * ] ] )", "matrix([[{1}]])", ""},
    {"np . array ( $ )", "{1}", ""},
    {"np . linalg . @ ( $ )", "{1}({2})", ""},
    {"np . pi", "PI", ""},
    {"math . pi", "PI", ""},
    {"np . arange ( * )", "range({1})", ""},
    {"np . deg2rad ( $ )", "toRadians({1})", ""},
    {"np . radians ( $ )", "toRadians({1})", ""},
    {"math . radians ( $ )", "toRadians({1})", ""},
    {"math . degrees ( $ )", "toDegrees({1})", ""},
    {"sorted ( $ )", "sort({1})", ""},
    {"isinstance ( $ , $ )", kNoSuchThing,
     "the type of every value is known before the program runs"},
    {"@ [ - 1 ]", "{1}.last", "a list ends with xs.last"},
    {"round ( $ , # )", "f\"{{1}:.{2}f}\"", "round gives a whole number; a format shows digits"},
    {"input ( * )", kNoSuchThing, "a program asks nobody while it runs"},
    // MATLAB
    {"@ [ end ]", "{1}.last", ""},
    {"@ ( end )", "{1}.last", ""},
    {"@ ( : , $ )", "{1}[:, {2}]", kFromZero},
    {"@ ( $ , : )", "{1}[{2}, :]", kFromZero},
    {"= @ ( # : $ )", "= {1}[{2}:{3}]", kFromZero},
    {"= # : # : #", "= range({1}, {3} + 1, {2})", ""},
    {"= # : #", "= range({1}, {2} + 1)", ""},
    {"= \\@ ( @ ) $", "= fn({1}: double) => {2}", ""},
    {"= \\@ ( @ , @ ) $", "= fn({1}: double, {2}: double) => {3}", ""},
    {"\\@ ( * ) $", "fn({1}) => {2}", ""},
    {"\\@ @", "{1}", ""},
    {"mod ( $ , $ )", "{1:operand} % {2:operand}", ""},
    {"rem ( $ , $ )", "{1:operand} % {2:operand}", ""},
    {"fix ( $ )", "trunc({1})", ""},
    {"sprintf ( * )", "{1:text}", ""},
    {"size ( $ , 1 )", "{1:operand}.rows", ""},
    {"size ( $ , 2 )", "{1:operand}.cols", ""},
    {"strcat ( $ , $ )", "{1} + {2}", ""},
    {"deg2rad ( $ )", "toRadians({1})", ""},
    {"rad2deg ( $ )", "toDegrees({1})", ""},
    {"% @ @ ...", "// {1} {2} {3}", "a comment starts with //"},
    // C, C++, Java
    {"@ ~-> ~@", "{1}.{2}", "a field stands behind a point"},
    {"( @ ) -> $", "fn({1}) => {2}", ""},
    {"( @ , @ ) -> $", "fn({1}, {2}) => {3}", ""},
    {"@ -> $", "fn({1}) => {2}", ""},
    {"sizeof ( @ ) / sizeof ( $ )", "{1}.length", ""},
    {"( int ) sizeof ( @ )", "{1}.length", ""},
    {"for ( ; ; )", "while (true)", ""},
    {"fabs ( $ )", "abs({1})", ""},
    {"M_PI", "PI", ""},
    {"$ instanceof @", kNoSuchThing, "the type of every value is known before the program runs"},
    {"@ . charAt ( $ )", "{1}[{2}]", ""},
    {"@ . get ( $ )", "{1}[{2}]", ""},
    {"@ . at ( $ )", "{1}[{2}]", ""},
    {"@ . isEmpty ( )", "({1}.length == 0)", ""},
    {"@ . empty ( )", "({1}.length == 0)", ""},
    {"@ . back ( )", "{1}.last", ""},
    {"@ . front ( )", "{1}[0]", ""},
    {"@ . containsKey ( $ )", "{1}.has({2})", ""},
    {"String . format ( * )", "{1:text}", ""},
    {"Integer . parseInt ( $ )", "parseInt({1})", ""},
    {"Double . parseDouble ( $ )", "parseDouble({1})", ""},
    {"Integer . MAX_VALUE", "2147483647", ""},
    {"System . currentTimeMillis ( )", "now() / 1ms", ""},
    {"static_cast < @ > ( $ )", "{1:type}({2})", ""},
    {"std :: @ ( $ )", "{1}({2})", ""},
    {"std :: @ ( $ , $ )", "{1}({2}, {3})", ""},
    {"std :: to_string ( $ )", "string({1})", ""},
    {"& @", "{1}", "values are copied; there are no pointers"},
    // URScript
    {"p [ $ , $ , $ , * ]", "xyz({1:m}, {2:m}, {3:m}){4:turn}", ""},
    {"get_digital_in ( # )", "signal(\"in{1}\")", kNamedSignals},
    {"get_standard_digital_in ( # )", "signal(\"in{1}\")", kNamedSignals},
    {"get_configurable_digital_in ( # )", "signal(\"in{1}\")", kNamedSignals},
    {"get_actual_tcp_pose ( )", "here()", ""},
    {"get_target_tcp_pose ( )", "here()", ""},
    {"get_actual_joint_positions ( )", "joints()", ""},
    {"get_target_joint_positions ( )", "joints()", ""},
    {"get_tcp_force ( )", "force()", ""},
    {"get_inverse_kin ( $ )", "ikine({1})", ""},
    {"get_forward_kin ( $ )", "fkine({1})", ""},
    {"pose_trans ( $ , $ )", "{1:operand} * {2:operand}", ""},
    {"pose_inv ( $ )", "inv({1})", ""},
    {"d2r ( $ )", "toRadians({1})", ""},
    {"r2d ( $ )", "toDegrees({1})", ""},
    // RAPID, KRL
    {"Offs ( $ , $ , $ , $ )", "xyz({2:mm}, {3:mm}, {4:mm}) * {1:operand}", ""},
    {"RelTool ( $ , $ , $ , $ )", "{1:operand} * xyz({2:mm}, {3:mm}, {4:mm})", ""},
    {"CRobT ( * )", "here()", ""},
    {"CJointT ( * )", "joints()", ""},
    {"NumToStr ( $ , # )", "f\"{{1}:.{2}f}\"", ""},
    {"ValToStr ( $ )", "string({1})", ""},
    {"DInput ( @ )", "signal(\"{1}\")", ""},
    {"DOutput ( @ )", "signal(\"{1}\")", ""},
    {"\\$ IN [ $ ]", "signal(\"in{1}\")", kNamedSignals},
    {"\\$ OUT [ $ ]", "signal(\"out{1}\")", kNamedSignals},
    {"\\$ POS_ACT", "here()", ""},
    {"\\$ AXIS_ACT", "joints()", ""},
});

}  // namespace

std::span<const Habit> value_habits() { return kValues; }

}  // namespace armlet::lang
