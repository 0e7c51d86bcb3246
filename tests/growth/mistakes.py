"""Programs with mistakes of every kind: they are found and reported in time proportional to the text."""

from shapes import lines, shape


@shape
def wrong_names(n):
    return lines(n, lambda i: f"var v{i} = {i}") + lines(n, lambda i: f"print(w{i}x)")


@shape
def wrong_calls(n):
    return lines(n, lambda i: f"fn f{i}() => 1") + lines(n, lambda i: f"print(g{i}x(1))")


@shape
def wrong_types(n):
    return lines(n, lambda i: f"struct S{i} {{ a: int }}") + lines(n, lambda i: f"var v{i}: T{i}x = 1")


@shape
def wrong_places(n):
    return lines(n, lambda i: f"var v{i} = {i}") + lines(n, lambda i: f"w{i}x = 1")


@shape
def wrong_fields(n):
    return "struct S { " + "; ".join(f"a{i}: int = 1" for i in range(n)) + " }\nvar s = S()\n" + lines(n, lambda i: f"print(s.b{i}x)")


@shape
def wrong_enum_values(n):
    return "enum E { " + ", ".join(f"V{i}" for i in range(n)) + " }\n" + lines(n, lambda i: f"print(E.W{i}x)")


@shape
def wrong_settings(n):
    return lines(n, lambda i: f"moveL(xyz(0mm, 0mm, 0mm), sped{i}: 1)")


@shape
def wrong_members(n):
    return lines(n, lambda i: f"print(Math.foo{i}(1), robots.bar{i}())")


@shape
def wrong_methods(n):
    return "var a = [1]\n" + lines(n, lambda i: f"a.foo{i}(1)")


@shape
def mismatches(n):
    return lines(n, lambda i: f"var v{i}: int = \"text\" ")


@shape
def wrong_units(n):
    return lines(n, lambda i: f"var v{i} = 1mm + 2s\nwait(5mm)")


@shape
def foreign_blocks(n):
    return lines(n, lambda i: f"FOR i FROM 1 TO {i} DO\n    print(i)\nENDFOR")


@shape
def foreign_ends(n):
    return lines(n, lambda i: " " * (i % 7) + "LOOP") + lines(n, lambda i: "    " * (i % 9) + "ENDFOR")


@shape
def foreign_values(n):
    return lines(n, lambda i: f"print(if else if else not in {i} if else is None or x -> [ for in for in ] ~= mod(mod(1, 2), 3))")


@shape
def declared_twice(n):
    return lines(n, lambda i: "var v = 1")


@shape
def functions_twice(n):
    return lines(n, lambda i: "fn f() => 1")


@shape
def enum_values_twice(n):
    return "enum E { " + ", ".join("V" for i in range(n)) + " }\n"


@shape
def fields_twice(n):
    return "struct S { " + "; ".join("a: int" for i in range(n)) + " }\n"


@shape
def cases_twice(n):
    return "var s = 1\nswitch (s) {\n" + lines(n, lambda i: "  case 1: print(1)") + "  default: print(0)\n}\n"


@shape
def missing_cases(n):
    return ("enum E { " + ", ".join(f"V{i}" for i in range(n)) + " }\nvar e = E.V0\n" + lines(n, lambda i: "switch (e) { case E.V1: print(1) }"))


@shape
def structs_in_circles(n):
    return lines(n, lambda i: f"struct S{i} {{ a: S{(i + 1) % n}; b: S{(i * 7) % n} }}")


@shape
def too_many_values(n):
    return lines(n, lambda i: "print(sqrt(1, 2, 3))")


@shape
def constant_changes(n):
    return "let a = 1\n" + lines(n, lambda i: f"a = {i}")


@shape
def missing_returns(n):
    return lines(n, lambda i: f"fn f{i}(x: int) -> int {{ if (x > 0) {{ return 1 }} }}")


@shape
def unreachable(n):
    return lines(n, lambda i: f"fn f{i}() -> int {{ return 1; print(1) }}")


@shape
def unused(n):
    return "fn f() -> int {\n" + lines(n, lambda i: f"  let v{i} = {i}") + "  return 1\n}\nprint(f())\n"


@shape
def advice(n):
    return lines(n, lambda i: "print(1 / 2)\nprint(sin(90))")


@shape
def syntax_errors(n):
    return lines(n, lambda i: "let = = 3")


@shape
def missing_brackets(n):
    return lines(n, lambda i: "print((1 + 2")


@shape
def extra_brackets(n):
    return lines(n, lambda i: "print(1 + 2))")


@shape
def open_blocks(n):
    return lines(n, lambda i: "if (true) { print(1)")


@shape
def stray_braces(n):
    return "}\n" * n


@shape
def open_texts(n):
    return lines(n, lambda i: 'print("abc)')


@shape
def open_comments(n):
    return "print(1)\n/* " + "x\n" * n


@shape
def foreign_characters(n):
    return lines(n, lambda i: "print(1) § € ¤")


@shape
def foreign_words(n):
    return lines(n, lambda i: "def f(x): return x")


@shape
def foreign_loops(n):
    return lines(n, lambda i: "for i in 1 to 3 do print(i) end")


@shape
def wrong_numbers(n):
    return lines(n, lambda i: "print(1..2, 0x1G, 1e, 5q)")


@shape
def missing_commas(n):
    return "print([" + " ".join(str(i) for i in range(n)) + "])\n"


@shape
def operators_missing(n):
    return "print(" + " ".join("a" for i in range(n)) + ")\n"


@shape
def lone_operators(n):
    return lines(n, lambda i: "+ * / 3")


@shape
def broken_functions(n):
    return lines(n, lambda i: f"fn f{i}(x: , y) -> {{ return }}")


@shape
def broken_structs(n):
    return lines(n, lambda i: f"struct S{i} {{ a int, b: }}")


@shape
def broken_cases(n):
    return "switch (1) {\n" + lines(n, lambda i: f"  case {i} print(1)") + "}\n"


@shape
def one_line_of_mistakes(n):
    return "; ".join(f"print(x{i}y)" for i in range(n)) + "\n"


@shape
def wide_line_before_mistake(n):
    return "print(" + ", ".join(f"\"ä{i}\"" for i in range(n)) + ", nix, " + ", ".join(f"{i}" for i in range(n)) + ")\n"


@shape
def missing_imports(n):
    return lines(n, lambda i: f"import m{i}")


@shape
def calls_that_fit_nothing(n):
    return lines(n, lambda i: "moveL(\"there\", 1, 2, 3)")


@shape
def active_after_return(n):
    return "fn f() {\n" + lines(n, lambda i: "  return\n  print(1)") + "}\n"
