"""Programs of many shapes, each a function of a size n: the text grows in proportion to n, and so may the work."""

SHAPES = {}
# Shapes that are laid out too.
FORMATS = {"functions", "arguments", "long_sum", "long_list", "matrix", "long_text", "many_formatted_texts", "if_chain", "enum_switch",
           "wide_struct", "robot_block", "watches", "comments", "trailing_comments", "blank_lines", "one_line", "broken_lines",
           "nested_calls", "nested_blocks", "conditional_ladders", "else_if_ladders", "long_condition", "with_blocks"}


def shape(make):
    SHAPES[make.__name__] = make
    return make


def lines(n, line):
    return "".join(line(i) + "\n" for i in range(n))


@shape
def statements(n):
    return "var s = 0\n" + lines(n, lambda i: f"s = s + {i} * 2")


@shape
def variables(n):
    return lines(n, lambda i: f"var v{i} = {'1' if i == 0 else f'v{i - 1} + 1'}")


@shape
def fixed_variables(n):
    return "let v0 = 1m\n" + lines(n, lambda i: f"let v{i + 1} = v{i} + v{i}") + f"moveL(xyz(v{n}, 0m, 0m))\n"


@shape
def unset_variables(n):
    return ("fn f(c: bool) -> int {\n" + lines(n, lambda i: f"  int v{i};") +
            lines(n, lambda i: f"  if (c) {{ v{i} = 1 }} else {{ v{i} = 2 }}") +
            "  return " + " + ".join(f"v{i}" for i in range(n)) + "\n}\nprint(f(true))\n")


@shape
def breaks_between_first_values(n):
    order = sorted(range(n), key=lambda i: (i * 7919) % n)
    return ("fn f(c: bool) -> int {\n" + lines(n, lambda i: f"  int v{i};") + "  while (c) {\n" +
            lines(n, lambda i: f"    v{order[i]} = 1; if (c) break") + "  }\n  return 1\n}\nprint(f(true))\n")


@shape
def cases_with_first_values(n):
    return ("fn f(c: int) -> int {\n" + lines(n, lambda i: f"  int v{i};") + "  switch (c) {\n" +
            lines(n, lambda i: f"    case {i}: v{i * 7 % n} = 1") + "    default: return 2\n  }\n  return 1\n}\nprint(f(1))\n")


@shape
def functions(n):
    return lines(n, lambda i: f"fn f{i}(x: int) -> int {{ return {'x' if i == 0 else f'f{i - 1}(x) + 1'} }}") + f"print(f{n - 1}(1))\n"


@shape
def functions_called_forward(n):
    return lines(n, lambda i: f"fn f{i}(x: int) -> int {{ return {'x' if i == n - 1 else f'f{i + 1}(x) + 1'} }}") + "print(f0(1))\n"


@shape
def calls_of_a_chain(n):
    return ("var g = 1\n" + lines(n, lambda i: f"fn f{i}(x: int) -> int {{ return {'g' if i == 0 else f'f{i - 1}(x)'} }}") +
            lines(n, lambda i: f"print(f{i}(1))"))


@shape
def globals_in_functions(n):
    return (lines(n, lambda i: f"var g{i} = {i}") + "fn f() -> int {\n" + lines(n, lambda i: f"  g{i} = g{i} + 1") +
            "  return g0\n}\nprint(f())\n")


@shape
def inferred_functions(n):
    return lines(n, lambda i: f"fn f{i}(x) => x + {i}\nprint(f{i}(1))")


@shape
def forms_of_one_function(n):
    return "fn f(x) => x\n" + lines(n, lambda i: f"print(f([{'[' * (i % 40)}{i}{']' * (i % 40)}]))")


@shape
def parameters(n):
    return ("fn f(" + ", ".join(f"p{i}: int = {i}" for i in range(n)) + ") => p0\nprint(f(" +
            ", ".join(f"p{i}: 1" for i in range(n)) + "))\n")


@shape
def arguments(n):
    return "fn f(" + ", ".join(f"p{i}: int" for i in range(n)) + ") -> int { return p0 }\nprint(f(" + ", ".join("1" for i in range(n)) + "))\n"


@shape
def variadic_arguments(n):
    return "print(posJ(" + ", ".join(f"{i}deg" for i in range(n)) + "))\n"


@shape
def default_lists(n):
    return ("fn f(x: int, xs: double[] = [" + ", ".join(f"{i}.5" for i in range(n)) + "]) => x + xs.length\n" +
            lines(n, lambda i: f"print(f({i}))"))


@shape
def structs(n):
    return (lines(n, lambda i: f"struct S{i} {{ a: int; b: double }}") + lines(n, lambda i: f"let s{i} = S{i}({i}, 1.5)\nprint(s{i}.b)"))


@shape
def nested_structs(n):
    return ("struct S0 { x: int }\n" + lines(n, lambda i: f"struct S{i + 1} {{ a: S{i}; b: S{i} }}") + "print(S0(1).x)\n")


@shape
def nested_defaults(n):
    n = min(n, 190)
    return ("struct S0 { x: int = 1 }\n" + lines(n, lambda i: f"struct S{i + 1} {{ a: S{i} = S{i}(); b: S{i} = S{i}() }}") +
            f"if (1 > 2) print(S{n}().a.b.a.a == S{n - 4}())\n")


@shape
def wide_struct(n):
    return ("struct S { " + "; ".join(f"a{i}: int" for i in range(n)) + " }\nvar s = S(" + ", ".join(f"a{i}: 1" for i in range(n)) +
            ")\n" + lines(n, lambda i: f"s.a{i} = s.a{i} + 1"))


@shape
def struct_lists(n):
    return lines(n, lambda i: f"struct S{i} {{ a: int }}\nvar s{i} = [S{i}(1)]\nprint(s{i}.length)")


@shape
def function_types(n):
    return lines(n, lambda i: f"struct S{i} {{ a: int }}\nlet f{i} = fn(s: S{i}) => s.a\nprint(f{i}(S{i}(1)))")


@shape
def enum(n):
    return "enum E { " + ", ".join(f"V{i}" for i in range(n)) + " }\nvar e = E.V0\n" + lines(n, lambda i: f"e = E.V{i}")


@shape
def enum_names(n):
    return ("enum E { " + ", ".join(f"V{i}" for i in range(n)) + " }\nvar e = E.V0\n" +
            lines(n, lambda i: f"print(e.name, E.values.length)"))


@shape
def enum_switch(n):
    return ("enum E { " + ", ".join(f"V{i}" for i in range(n)) + " }\nvar e = E.V0\nswitch (e) {\n" +
            lines(n, lambda i: f"  case E.V{i}: print({i})") + "}\n")


@shape
def enums(n):
    return lines(n, lambda i: f"enum E{i} {{ A, B }}\nvar e{i} = E{i}.A")


@shape
def text_switch(n):
    return 'var s = "a"\nswitch (s) {\n' + lines(n, lambda i: f'  case "k{i}": print({i})') + "  default: print(0)\n}\n"


@shape
def int_switch(n):
    return "var s = 1\nswitch (s) {\n" + lines(n, lambda i: f"  case {i}: print({i}); break") + "  default: print(0)\n}\n"


@shape
def long_sum(n):
    return "var a = 1\nprint(" + " + ".join("a" for i in range(n)) + ")\n"


@shape
def long_literal_sum(n):
    return "print(" + " + ".join("1" for i in range(n)) + ")\n"


@shape
def long_divisions(n):
    return "print(" + " / 2 * ".join("3" for i in range(n)) + ")\n"


@shape
def long_text_sum(n):
    return 'var a = "x"\nprint(' + " + ".join(f'a + "{i}"' for i in range(n)) + ")\n"


@shape
def long_condition(n):
    return "var a = 1\nif (" + " && ".join(f"a < {i}" for i in range(n)) + ") print(1)\n"


@shape
def long_assertion(n):
    return "var a = 1\nassert(" + " && ".join(f"a < {i}" for i in range(n)) + ")\n"


@shape
def long_list(n):
    return "var a = [" + ", ".join(f"{i}.5" for i in range(n)) + "]\nprint(a.length)\n"


@shape
def mixed_list(n):
    return "var a = [" + ", ".join(f"{i}" for i in range(n)) + ", 0.5]\nprint(a.length)\n"


@shape
def list_of_lists(n):
    return "var a = [" + ", ".join(f"[{i}, 1.5]" for i in range(n)) + "]\nprint(a.length)\n"


@shape
def poses(n):
    return "let p = [" + ", ".join(f"xyz({i}mm, 1mm, 2mm)" for i in range(n)) + "]\nprint(p.length)\n"


@shape
def matrix(n):
    return "var m = [" + "; ".join(f"{i}, 1, 2" for i in range(n)) + "]\nprint(m)\n"


@shape
def list_used_often(n):
    return "let q = [" + ", ".join("0.1" for i in range(n)) + "]\n" + lines(n, lambda i: f"print(norm(q) + {i})")


@shape
def doubled_lists(n):
    return "let a0 = [1.5]\n" + lines(n, lambda i: f"let a{i + 1} = [a0, a0]\nprint(a{i + 1}.length)")


@shape
def long_text(n):
    return 'print("' + "abcdefgh" * n + '")\n'


@shape
def formatted_text(n):
    return 'var a = 1.5\nprint(f"' + "x {a:.2f} " * n + '")\n'


@shape
def many_formatted_texts(n):
    return 'var a = 1.5\n' + lines(n, lambda i: 'print(f"a is {a:.2f}, {a + 1} and {a * 2}")')


@shape
def if_chain(n):
    return "var a = 1\n" + lines(n, lambda i: f"if (a > {i}) {{ a = {i} }} else if (a < {i}) {{ a = 2 }} else {{ a = 3 }}")


@shape
def loops(n):
    return "var a = 1\n" + lines(n, lambda i: f"for (i{i} in range(3)) {{ a = a + i{i} }}\nwhile (a < {i}) {{ a = a + 1 }}")


@shape
def one_long_loop(n):
    return "var a = 1\nvar b = [1.5]\nfor (i in range(3)) {\n" + lines(n, lambda i: f"  a = a + {i}\n  b[0] = b[0] * 2 + a") + "}\nprint(a)\n"


@shape
def locals_of_one_function(n):
    return ("fn f(x: int) -> int {\n" + lines(n, lambda i: f"  let v{i} = {'x' if i == 0 else f'v{i - 1}'} + {i}") + f"  return v{n - 1}\n}}\nprint(f(1))\n")


@shape
def live_locals(n):
    return ("fn f(x: int) -> int {\n" + lines(n, lambda i: f"  var v{i} = x + {i}\n  if (v{i} > 3) {{ v{i} = 2 }}") +
            "  return " + " + ".join(f"v{i}" for i in range(n)) + "\n}\nprint(f(1))\n")


@shape
def blocks(n):
    return lines(n, lambda i: f"{{ let x{i} = {i}; {{ let y{i} = x{i}; print(y{i}) }} }}")


@shape
def lambdas(n):
    return lines(n, lambda i: f"let f{i} = fn(x: int) => x + {i}\nprint(f{i}(1))")


@shape
def captures(n):
    return ("fn f(x: int) -> int {\n" + lines(n, lambda i: f"  let v{i} = x + {i}") +
            "  let g = fn(y: int) => " + " + ".join(f"v{i}" for i in range(n)) + "\n  return g(1)\n}\nprint(f(1))\n")


@shape
def list_functions(n):
    return "let a = [1.5, 2.5]\n" + lines(n, lambda i: f"print(sum(map(a, fn(x) => x * {i})))")


@shape
def method_calls(n):
    return "let a = [1.5, 2.5]\n" + lines(n, lambda i: f"print(a.sum(), Math.sqrt({i}.0), a.length)")


@shape
def pushes(n):
    return "var a: int[] = []\n" + lines(n, lambda i: f"a.push({i})")


@shape
def moves(n):
    return lines(n, lambda i: f"moveL(xyz(400mm, {i % 50}mm, 100mm), speed: 100mm/s)")


@shape
def moves_among_variables(n):
    return lines(n, lambda i: f"var v{i} = {i}mm") + lines(n, lambda i: f"moveL(xyz(400mm, v{i}, 100mm))")


@shape
def robots(n):
    return lines(n, lambda i: f"robot r{i} = robots.scara()") + lines(n, lambda i: f"r{i}.moveJ(r{i}.home())")


@shape
def robot_block(n):
    n = min(n, 60)
    return "robot r {\n" + lines(n, lambda i: "  joint revolute(a: 10mm, alpha: 0deg, d: 0mm)") + "}\nprint(1)\n"


@shape
def objects(n):
    return lines(n, lambda i: f"object o{i} {{ shape: box(10mm, 10mm, 10mm); at: xyz({i}mm, 0mm, 0mm) }}") + lines(n, lambda i: f"print(getPosObj(\"o{i}\"))")


@shape
def paths(n):
    return "path(speed: 100mm/s) {\n" + lines(n, lambda i: f"  moveL(xyz(400mm, {i % 50}mm, 100mm))") + "}\n"


@shape
def many_paths(n):
    return lines(n, lambda i: f"path(speed: 100mm/s) {{ moveL(xyz(400mm, {i % 50}mm, 100mm)); moveL(xyz(410mm, {i % 50}mm, 100mm)) }}")


@shape
def with_blocks(n):
    return "robot r = robots.scara()\n" + lines(n, lambda i: f"with (robot: r) {{ moveL(xyz(400mm, {i % 50}mm, 100mm)) }}")


@shape
def guards(n):
    return ("var g = 1\n" + lines(n, lambda i: f"fn f{i}() -> bool {{ return {'g > 1' if i == 0 else f'f{i - 1}()'} }}") +
            lines(n, lambda i: f"wait until (f{i}())"))


@shape
def tasks(n):
    return "var g = 1\nparallel {\n" + lines(n, lambda i: f"  {{ wait(1s); g = g + {i} }}") + "}\n"


@shape
def many_parallels(n):
    return "var g = 1\n" + lines(n, lambda i: f"parallel {{ {{ wait(1s); g = g + {i} }} {{ wait(2s) }} }}")


@shape
def watches(n):
    return "var g = 1\n" + lines(n, lambda i: f"when (g > {i}) {{ g = 0 }}\nevery (10ms) {{ g = g + 1 }}")


@shape
def records(n):
    return lines(n, lambda i: f"{{ record run{i} every (10ms) {{ q{i}: {i} }} }}")


@shape
def record_columns(n):
    return "record run every (10ms) { " + "; ".join(f"q{i}: {i}" for i in range(n)) + " }\n" + lines(n, lambda i: f"print(run.q{i})")


@shape
def tries(n):
    return "var a = 1\n" + lines(n, lambda i: f"try {{ a = {i} }} catch (e) {{ print(e.message) }} finally {{ a = 2 }}")


@shape
def tests(n):
    return ("var g = 1\nfn f() -> int { return g }\n" + lines(n, lambda i: f'test "number {i}" {{ assert(f() == 1) }}'))


@shape
def comments(n):
    return "print(1)\n" + lines(n, lambda i: f"// comment {i}") + "print(2)\n" + "/* " + "long\n" * n + "*/\n"


@shape
def trailing_comments(n):
    return lines(n, lambda i: f"print({i})   // number {i}\n/// doc {i}")


@shape
def blank_lines(n):
    return "print(1)\n" + "\n" * 20 * n + "print(2)\n" + "   \n" * n


@shape
def semicolons(n):
    return "print(1)" + ";" * 10 * n + "\n"


@shape
def one_line(n):
    return "; ".join(f"print({i})" for i in range(n)) + "\n"


@shape
def broken_lines(n):
    return "print(1" + "".join(f"\n   + {i}" for i in range(n)) + ")\n"


@shape
def nested_calls(n):
    depth = 100
    return lines(n // depth, lambda i: "print(" + "abs(" * depth + "1" + ")" * depth + ")")


@shape
def nested_lists(n):
    depth = 100
    return lines(n // depth, lambda i: f"let a{i} = " + "[" * depth + "1, 2.5" + "]" * depth)


@shape
def nested_blocks(n):
    depth = 60
    return lines(n // depth, lambda i: "if (true) { " * depth + "print(1)" + " }" * depth)


@shape
def else_if_ladders(n):
    depth = 90
    return "var a = 1\n" + lines(n // depth, lambda i: "if (a == 0) { print(0) }" + "".join(f" else if (a == {k}) {{ print({k}) }}" for k in range(depth)))


@shape
def conditional_ladders(n):
    depth = 90
    return "var a = 1\n" + lines(n // depth, lambda i: "print(" + "".join(f"a == {k} ? {k} : " for k in range(depth)) + "7)")


@shape
def member_chains(n):
    depth = 90
    return "struct S { x: int }\n" + lines(n // depth, lambda i: "print(" + "[" * depth + "1" + "]" * depth + "[0]" * depth + ")")


@shape
def chained_assignments(n):
    return "var a = 1\nvar b = 2\n" + lines(n // 2, lambda i: "a = b = 1")


@shape
def compound_assignments(n):
    return "var a = [1, 2]\n" + lines(n, lambda i: f"a[{i % 2}] += {i}\na[0]++")


@shape
def slices(n):
    return "var a = [1, 2, 3]\nvar m = [1, 2; 3, 4]\n" + lines(n, lambda i: "print(a[0:2], m[0, :], m[1, 1])")


@shape
def classic(n):
    return lines(n, lambda i: f"int v{i} = {i};\nSystem.out.println(\"v\" + v{i});")
