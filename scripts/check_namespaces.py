#!/usr/bin/env python3
"""Holds the rules of names: each folder has its namespace, and no two types share a name in one namespace.

    scripts/check_namespaces.py [ROOT]      checks the repository; exit code 1 and one line per fault
    scripts/check_namespaces.py --self-test plants one fault of each kind and sees that it is found
"""

import re
import sys
import tempfile
from pathlib import Path

# The namespace of a folder's files; the longest path decides. What the engine offers to those who embed it is in
# `voussoir` itself.
NAMESPACES = {
    "libdda/": "voussoir",
    "libdda/text/": "voussoir::text",
    "libdda/run/": "voussoir::driver",
    "libdda/run/run.": "voussoir",
    "libdda/run/static_course.": "voussoir",
    "libdda/contact/": "voussoir::contact",
    "libdda/contact/initial_contacts.": "voussoir",
    "libdda/solve/": "voussoir::solve",
    # The inside of a step is one namespace in several rooms.
    "libdda/limit/": "voussoir::limit",
    "libdda/block/": "voussoir::step",
    "libdda/forces/": "voussoir::step",
    "libdda/problem/": "voussoir::step",
    "libdda/iterate/": "voussoir::step",
    "libdda/impact/": "voussoir::step",
    "libdda/step/": "voussoir::step",
    "libdda/step/advance.": "voussoir",
    "libdda/step/work.": "voussoir",
    "libdda/step/workspace.": "voussoir",
    "records/": "voussoir::records",
    "records/formats/": "voussoir::records::formats",
    "records/measures/": "voussoir::records::measures",
    "records/processing/": "voussoir::records::processing",
    "records/synthetic/": "voussoir::records::synthetic",
    "importers/": "voussoir::importers",
    "importers/assembly/": "voussoir::importers::assembly",
    "importers/exact/": "voussoir::importers::exact",
    "importers/fit/": "voussoir::importers::fit",
    "importers/helper/": "voussoir::importers::helper",
    "importers/mesh/": "voussoir::importers::mesh",
    "importers/patterns/": "voussoir::importers::patterns",
    "importers/process/": "voussoir::importers::process",
    "app/": "voussoir::app",
    "app/command_line/": "voussoir::app::command_line",
    "app/commands/": "voussoir::app::commands",
    "app/drawing/": "voussoir::app::drawing",
    "app/generate/": "voussoir::app::generate",
    "app/golden/": "voussoir::app::golden",
    "app/plots/": "voussoir::app::plots",
    "app/problems/": "voussoir::app::problems",
    "app/reader/": "voussoir::app::reader",
    "app/render/": "voussoir::app::render",
    "app/report/": "voussoir::app::report",
    "app/results/": "voussoir::app::results",
    "app/studies/converge/": "voussoir::app::studies::converge",
    "app/studies/ensemble/": "voussoir::app::studies::ensemble",
    "app/studies/limit/": "voussoir::app::studies::limit",
    "app/studies/scenes/": "voussoir::app::studies::scenes",
    "app/studies/stability/": "voussoir::app::studies::stability",
    "app/studies/stability/references/": "voussoir::app::studies::stability::references",
    "app/studies/verify/": "voussoir::app::studies::verify",
    "app/studies/verify/references/": "voussoir::app::studies::verify::references",
    "app/version/": "voussoir::app::version",
    "app/words/": "voussoir::app::words",
}
MODULES = ("libdda", "importers", "records", "app")

OPENING = re.compile(r"^(?:inline )?namespace(?: ((?:\w+::)*\w+))?\s*$")
CLOSING = re.compile(r"^}  // namespace\b")
TYPE = re.compile(r"^(?:template <[^;]*>\s*)?(?:struct|class|enum(?: class)?) (\w+)(?: final)?(?: : [^;]*)?(?: \{.*)?$")
FORWARD = re.compile(r"^(?:struct|class) \w+;(?: *//.*)?$")


def namespace_of(path):
    return NAMESPACES[max((folder for folder in NAMESPACES if path.startswith(folder)), key=len)]


def read(path, text):
    """The namespaces that a file opens at its outermost level, and the types it defines as (qualified name, line)."""
    outermost, types, open_names = [], [], []
    for number, line in enumerate(text.splitlines(), start=1):
        opening = OPENING.match(line)
        if opening:
            if not open_names:
                outermost.append((opening.group(1) or "", number))
            open_names.append(opening.group(1) or f"<{path}>")
        elif CLOSING.match(line) and open_names:
            open_names.pop()
        elif open_names and TYPE.match(line) and not FORWARD.match(line):
            types.append(("::".join(open_names + [TYPE.match(line).group(1)]), number))
    return outermost, types


def check(root):
    faults, defined, count = [], {}, 0
    for file in sorted(file for module in MODULES if (root / module).is_dir() for file in (root / module).rglob("*")):
        if file.suffix not in (".h", ".cpp"):
            continue
        count += 1
        path = file.relative_to(root).as_posix()
        outermost, types = read(path, file.read_text(encoding="utf-8"))
        wanted = namespace_of(path)
        for name, line in outermost:
            # A program's main file may have an unnamed one alone; types of another module or library may be announced.
            if name and name != wanted and not announces_only(file, line):
                faults.append(f"{path}:{line}: namespace {name}, must be {wanted}")
        for name, line in types:
            if name in defined:
                faults.append(f"{path}:{line}: {name} is defined in {defined[name]} too")
            defined.setdefault(name, f"{path}:{line}")
    return count, faults


def announces_only(file, line):
    """Whether a namespace holds nothing but forward declarations: another module's types, by name."""
    for text in file.read_text(encoding="utf-8").splitlines()[line:]:
        if CLOSING.match(text) or text == "}":
            return True
        if text.strip() not in ("", "{") and not FORWARD.match(text):
            return False
    return False


def planted(files):
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for path, text in files.items():
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text(text, encoding="utf-8")
        return len(check(root)[1])


def body(namespace, text):
    return f"namespace {namespace}\n{{\n\n{text}\n\n}}  // namespace {namespace}\n"


def self_test():
    cases = (
        ("its own namespace", {"records/a.h": body("voussoir::records", "struct A {\n};")}, 0),
        ("that of its folder", {"records/formats/a.h": body("voussoir::records", "struct A {\n};")}, 1),
        ("another one", {"app/words/a.h": body("elsewhere", "struct A {\n};")}, 1),
        ("a forward declaration", {"app/words/a.h": body("voussoir", "struct Model;")}, 0),
        ("a type that is there twice", {"app/words/a.h": body("voussoir::app::words", "struct A {\n};"),
                                        "app/words/b.h": body("voussoir::app::words", "class A\n{\n};")}, 1),
        ("one name in two namespaces", {"app/words/a.h": body("voussoir::app::words", "struct A {\n};"),
                                        "records/b.h": body("voussoir::records", "struct A {\n};")}, 0),
        ("hidden in two files", {f"records/{name}.cpp": "namespace voussoir::records\n{\n\nnamespace\n{\n\nstruct A {\n};\n\n"
                                 "}  // namespace\n\n}  // namespace voussoir::records\n" for name in "ab"}, 0),
    )
    return len(cases), [f"{name}: {planted(files)} faults, must be {faults}" for name, files, faults in cases
                        if planted(files) != faults]


def main(arguments):
    if arguments == ["--self-test"]:
        count, faults = self_test()
        subject = "planted files judged rightly"
    else:
        count, faults = check(Path(arguments[0]) if arguments else Path(__file__).resolve().parent.parent)
        subject = "files keep to their namespaces"
    for fault in faults:
        print(fault)
    if not faults:
        print(f"{count} {subject}")
    return 1 if faults or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
