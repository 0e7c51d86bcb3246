// Types of values, the five conversions, and units (language reference, sections 5 to 8).

#include <doctest/doctest.h>

#include "check_vocabulary.hpp"

namespace armlet::lang {
namespace {

TEST_CASE("numbers mix to double, whole numbers stay whole") {
  CHECK(type_of("1 + 2") == "int");
  CHECK(type_of("7 / 2.0") == "double");
  CHECK(type_of("2 ^ 3") == "int");
  CHECK(type_of("2 ^ -1") == "double");
  CHECK(type_of("7 % 2.5") == "double");
  CHECK(type_of("-(1)") == "int");
  CHECK(type_of("-9223372036854775808") == "int");
  CHECK(type_of("9223372036854775808") == "E0109");
}

TEST_CASE("dimensions follow products, quotients and powers") {
  CHECK(type_of("100mm / 2s") == "speed");
  CHECK(type_of("2 * 3mm") == "length");
  CHECK(type_of("3mm * 3mm") == "area");
  CHECK(type_of("(3mm) ^ 2") == "area");
  CHECK(type_of("(3mm) ^ 0.5 * (3mm) ^ 0.5") == "length");
  CHECK(type_of("5mm / 1mm") == "double");
  CHECK(type_of("sqrt(9mm^2)") == "length");
  CHECK(type_of("trapz([1N, 2N], [1m, 2m])") == "torque");
  CHECK(type_of("1kg * 1m / 1s^2") == "force");
}

TEST_CASE("an angle loses its unit where the rest fits, and never gains it") {
  CHECK(check_text("let x: double = 90deg")->ok);
  CHECK(check_text("let w: frequency = 3rad/s")->ok);
  CHECK(check_text("let q: angle = 90")->codes() == "E0401");
  CHECK(check_text("let q: angle = 0")->ok);
  CHECK(type_of("90deg + 0.1") == "E0401");
  CHECK(type_of("3rad/s + 2Hz") == "frequency");
  CHECK(type_of("sin(90deg) + sin(0.5)") == "double");
  CHECK(type_of("1mm + 1s") == "E0402");
  CHECK(type_of("1mm < 2") == "E0401");
  CHECK(type_of("1mm > 0") == "bool");
}

TEST_CASE("exponents of quantities are constant multiples of one half") {
  CHECK(type_of("(3mm) ^ n", "var n = 2\nn = 3") == "E0408");
  CHECK(type_of("(3mm) ^ n", "let n = 2") == "area");
  CHECK(type_of("(3mm) ^ 0.3") == "E0408");
  CHECK(type_of("(3mm) ^ 100") == "E0409");
}

TEST_CASE("lists take the type of their values or of their target") {
  CHECK(type_of("[1, 2, 3]") == "int[]");
  CHECK(type_of("[1, 2.5]") == "double[]");
  CHECK(type_of("[0, 2mm]") == "length[]");
  CHECK(type_of("[[1, 2], [3.5]]") == "double[][]");
  CHECK(type_of("[1, \"two\"]") == "E0330");
  CHECK(type_of("[]") == "E0323");
  CHECK(check_text("let x: double[] = [1, 2]")->ok);
  CHECK(check_text("double[] q = {45deg, 30deg, 0.1, 0};")->ok);
  CHECK(check_text("double[][] a = {{1, 2}, {3, 4}};")->ok);
  CHECK(check_text("let x: double[] = []")->ok);
  CHECK(check_text("let n = [1, 2]\nlet x: double[] = n")->ok);
  CHECK(check_text("let n = [1mm]\nlet x: double[] = n")->codes() == "E0315");
  CHECK(check_text("double[] q = {1, 2mm};")->codes() == "E0405");
}

TEST_CASE("parts of lists, texts, records and host values have their types") {
  CHECK(type_of("[1, 2][0]") == "int");
  CHECK(type_of("[1, 2][0:1]") == "int[]");
  CHECK(type_of("[1, 2].length") == "int");
  CHECK(type_of("[1, 2].last") == "int");
  CHECK(type_of("\"abc\"[0]") == "string");
  CHECK(type_of("\"abc\".length()") == "int");
  CHECK(type_of("xyz(1mm).z") == "length");
  CHECK(type_of("posJ(1deg, 2mm)[0]") == "double");
  CHECK(type_of("P(a: 1).a", "struct P { a: double }") == "double");
  CHECK(type_of("new double[3][4]") == "double[][]");
  CHECK(type_of("new int[3][]") == "int[][]");
  CHECK(type_of("3[0]") == "E0318");
  CHECK(type_of("xyz().height") == "E0208");
}

TEST_CASE("text joins with anything and compares with text only") {
  CHECK(type_of("\"n = \" + 3 + 4mm + true") == "string");
  CHECK(type_of("1 + 2 + \"a\"") == "string");
  CHECK(type_of("\"a\" == \"b\"") == "bool");
  CHECK(type_of("\"a\" == 1") == "E0316");
  CHECK(type_of("\"3\" * 2") == "E0314");
  CHECK(type_of("f\"{1.5:.1f} and {20mm:.1f mm}\"") == "string");
  CHECK(type_of("f\"{20mm:.1f s}\"") == "E0402");
  CHECK(type_of("f\"{20mm:.1f milli}\"") == "E0209");
  CHECK(type_of("f\"{0.5:.1f deg}\"") == "string");
}

TEST_CASE("conditions are bool and both sides of ?: agree") {
  CHECK(check_text("if (3) { print(1) }")->codes() == "E0309");
  CHECK(type_of("true && 1 > 0") == "bool");
  CHECK(type_of("1 && true") == "E0309");
  CHECK(type_of("true ? 1 : 2.5") == "double");
  CHECK(type_of("true ? 1mm : 0") == "length");
  CHECK(type_of("true ? 1 : \"one\"") == "E0311");
  CHECK(type_of("!3") == "E0317");
}

TEST_CASE("casts cut toward zero and need a plain number") {
  CHECK(type_of("int(3.7)") == "int");
  CHECK(type_of("(int) 3.7") == "int");
  CHECK(type_of("double(3)") == "double");
  CHECK(type_of("double(90deg)") == "double");
  CHECK(type_of("double(3mm)") == "E0405");
  CHECK(type_of("int(\"3\")") == "E0325");
}

TEST_CASE("an enum has values, names and a list of both") {
  const std::string light = "enum Light { Red, Green }";
  CHECK(type_of("Light.Red", light) == "Light");
  CHECK(type_of("Light.values", light) == "Light[]");
  CHECK(type_of("Light.Red.name", light) == "string");
  CHECK(type_of("Light.Blue", light) == "E0218");
  CHECK(type_of("Light.Red == Light.Green", light) == "bool");
  CHECK(type_of("Light.Red < Light.Green", light) == "E0316");
}

TEST_CASE("a chain of hundreds of operators is checked without deep recursion") {
  std::string sum = "1";
  for (int i = 0; i < 900; ++i) sum += " + 1";
  CHECK(type_of(sum) == "int");
  std::string text = "\"a\"";
  for (int i = 0; i < 900; ++i) text += " + 1";
  CHECK(type_of(text) == "string");
}

}  // namespace
}  // namespace armlet::lang
