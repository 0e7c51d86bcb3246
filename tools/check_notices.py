#!/usr/bin/env python3
"""Compares NOTICE and what the page's About shows with the list of the software of others, notices/parts.json.

usage: check_notices.py [--write]

--write makes both again. What the list names is compared with what is linked and bundled by tests/notices.py and, when the
page is built, by apps/lab/page/notices.ts.
"""
import difflib
import json
import pathlib
import sys
import textwrap

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIST = ROOT / "notices" / "parts.json"
TEXTS = ROOT / "notices" / "texts"
NOTICE = ROOT / "NOTICE"
OF_PAGE = ROOT / "apps" / "lab" / "page" / "src" / "about" / "notices.json"

PLACES = {
    "command": "the command armlet, and libraries of hosts",
    "planner": "the planners around obstacles (libarmlet_planning.so)",
    "vision": "functions of pictures by OpenCV (libarmlet_vision.so)",
    "video": "videos by OpenCV (libarmlet_video.so)",
    "converter": "the converter of meshes (armlet-mesh)",
    "page": "the page of laboratories",
    "engine": "the engine for pages (WebAssembly), and so every exported laboratory",
    "hosts": "programs that use Armlet as a library",
}
SHOWN = ("name", "version", "licence", "copyright", "home", "source", "in", "loaded", "texts", "note")


def parts():
    return json.loads(LIST.read_text(encoding="utf-8"))["parts"]


def text_of(name):
    return (TEXTS / f"{name}.txt").read_text(encoding="utf-8")


def faults(rows):
    """The mistakes in the list itself."""
    for row in rows:
        name = row["name"]
        if not row["copyright"] or not row["licence"] or not row["home"].startswith("https://"):
            yield f"{name}: licence, copyright and home are needed"
        for place in row["in"] + row.get("loaded", []):
            if place not in PLACES:
                yield f"{name}: there is no component {place}"
        if not row["in"] + row.get("loaded", []):
            yield f"{name}: nothing contains or loads it"
        if row["licence"].startswith("MPL") and row["in"] and "source" not in row:
            yield f"{name}: MPL-2.0 needs the address of the sources"
    named = {text for row in rows for text in row["texts"]}
    there = {path.stem for path in TEXTS.iterdir()}
    yield from (f"notices/texts/{text}.txt is {'missing' if text in named else 'used by no part'}" for text in sorted(named ^ there))


def entry(row):
    version = f" {row['version']}" if "version" in row else ""
    lines = [f"{row['name']}{version}", f"  {row['home']}", f"  Licence: {row['licence']}"]
    for text in row["texts"]:
        lines[-1] += f" ({'text' if text == row['texts'][0] else 'and'} {text} below{')' if text == row['texts'][-1] else ''}"
    lines += [f"  Copyright (c) {line}" for line in row["copyright"]]
    if "source" in row:
        lines.append(f"  Sources: {row['source']}")
    if "note" in row:
        lines.append(f"  {row['note']}")
    return "\n".join(textwrap.fill(line, 118, subsequent_indent="    ", break_long_words=False, break_on_hyphens=False) for line in lines)


def notice(rows):
    out = ["Armlet contains and loads software of others. Its own licence is in LICENSE.\n"
           "This file is made of notices/parts.json by tools/check_notices.py --write; `armlet --notices` prints it."]
    for place, what in PLACES.items():
        inside = [row for row in rows if place in row["in"]]
        if inside:
            out.append(f"== Part of {what}")
            out += [entry(row) for row in inside]
    out.append("== Not part of Armlet: libraries of the system that it loads where they are installed\n"
               "Their licences are in /usr/share/doc/*/copyright on Debian, as are those of the libraries that they load in turn.")
    for row in rows:
        if "loaded" in row and not row["in"]:
            out.append(entry(row) + "\n" + textwrap.fill("  Loaded by " + "; ".join(PLACES[place] for place in row["loaded"]), 118, subsequent_indent="    "))
    for name in sorted({text for row in rows for text in row["texts"]}):
        out.append(f"== Text {name}")
        out.append(text_of(name).strip("\n"))
    return "\n\n".join(out) + "\n"


def of_page(rows):
    """The list, and the texts for the parts that the page and its engine contain."""
    needed = sorted({text for row in rows if {"page", "engine"} & set(row["in"]) for text in row["texts"]})
    shown = [{key: row[key] for key in SHOWN if key in row} for row in rows]
    return json.dumps({"places": PLACES, "parts": shown, "texts": {name: text_of(name).strip("\n") for name in needed}}, ensure_ascii=False, indent=1) + "\n"


def main():
    rows = parts()
    wrong = list(faults(rows))
    for path, text in ((NOTICE, notice(rows)), (OF_PAGE, of_page(rows))):
        if "--write" in sys.argv:
            path.parent.mkdir(exist_ok=True)
            path.write_text(text, encoding="utf-8")
            continue
        old = path.read_text(encoding="utf-8") if path.exists() else ""
        if old != text:
            name = path.relative_to(ROOT)
            wrong += list(difflib.unified_diff(old.splitlines(), text.splitlines(), str(name), "notices/parts.json", lineterm="", n=0))[:20]
            wrong.append(f"{name} is not what notices/parts.json says; ./dev generate docs")
    print("\n".join(wrong), end="\n" if wrong else "")
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
