#include "vocabulary/language_words.hpp"

namespace armlet::lang {
namespace {

// The signatures are for documentation: `T` and `V` are any types, `K` is string, int or an enum.
constexpr NativeFunction kWords[] = {
    {"print", "(values...)", "Writes its values, separated by spaces, and ends the line.",
     "print(1, \"two\", 3mm)"},
    {"error", "(text: string, kind: string) -> error",
     "Makes an error to throw; the kind is what a catch can select by.",
     "try { throw error(\"no part left\", kind: \"empty\") } catch (e) { print(e.kind) }"},
    {"assert", "(condition: bool, note: string?)",
     "Stops the program, or fails the test, if the condition is false, and shows the values of its "
     "parts.",
     "assert(1 + 1 == 2, \"sums work\")"},
    {"assertThrows", "(f: fn() -> T, kind: string?)",
     "Fails if calling f raises no error, or one of another kind.",
     "assertThrows(fn() => [1][3], kind: \"IndexError\")"},
    {"int", "(x: double | int) -> int", "The number without its fraction.", "int(2.9)"},
    {"double", "(x: double | int) -> double", "The number as a double.", "double(3)"},
    {"string", "(x: T) -> string", "The text that print writes for a value.",
     "string([1, 2]) + \" parts\""},
    {"push", "(xs: T[], x: T)", "Appends x to a list that can be changed.",
     "var parts = [1, 2]; parts.push(3); print(parts)"},
    {"pop", "(xs: T[]) -> T", "Removes the last value of a list and gives it.",
     "var parts = [1, 2]; print(parts.pop(), parts)"},
    {"insert", "(xs: T[], i: int, x: T)", "Puts x before the value at index i.",
     "var parts = [1, 3]; parts.insert(1, 2); print(parts)"},
    {"removeAt", "(xs: T[], i: int) -> T", "Removes the value at index i and gives it.",
     "var parts = [1, 2, 3]; print(parts.removeAt(0), parts)"},
    {"length", "(xs: T[] | V[K] | string) -> int",
     "How many values a list has, entries a map, or characters a text.", "[1, 2].length"},
    {"map", " V[K]",
     "Values found by keys: [\"bolt\": 3] is an int[string], [:] is empty. m[k] reads and stores.",
     "var stock = [\"bolt\": 3]; stock[\"nut\"] = 5; for (name, n in stock) { print(name, n) }"},
    {"get", "(m: V[K], k: K, otherwise: V) -> V",
     "The value of a key in a map, or the other one if there is no such key.",
     "[\"bolt\": 3].get(\"nut\", 0)"},
    {"has", "(m: V[K], k: K) -> bool", "Whether a map has a key.", "[\"bolt\": 3].has(\"nut\")"},
    {"remove", "(m: V[K], k: K) -> V", "Takes an entry out of a map and gives its value.",
     "var stock = [\"bolt\": 3]; print(stock.remove(\"bolt\"), stock)"},
    {"keys", "(m: V[K]) -> K[]", "The keys of a map, in the order of their insertion.",
     "[\"bolt\": 3, \"nut\": 5].keys()"},
    {"values", "(m: V[K]) -> V[]", "The values of a map, in the order of their keys.",
     "[\"bolt\": 3, \"nut\": 5].values()"},
    {"last", "(xs: T[]) -> T", "The last value of a list.", "[1, 2].last"},
};

}  // namespace

std::span<const NativeFunction> language_words() { return kWords; }

}  // namespace armlet::lang
