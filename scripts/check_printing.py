#!/usr/bin/env python3
"""Holds the rule that all words for a terminal pass one function (app/commands/say.h, importers/process/program_start.h), which
shows what would command it.

    scripts/check_printing.py [ROOT]      checks the repository; exit code 1 and one line per fault
    scripts/check_printing.py --self-test plants faults and sees that they are found
"""

import re
import sys
from pathlib import Path

PRINTS = re.compile(r"\b(fmt::print|std::v?f?printf|std::f?puts|std::putchar|std::fwrite|std::cout|std::cerr|std::clog)\b")
TO_STDERR_LITERAL = re.compile(r'std::f(puts|printf)\("[^"%]*"(, stderr)?')  # words of our own

# What writes: the two functions themselves; an assertion; and the mains of helpers and developers' programs, whose
# standard output is an answer to the program that asked.
MAY = ("app/commands/say.cpp", "importers/process/program_start.cpp", "libdda/errors.cpp", "app/golden/golden_main.cpp",
       "app/generate/generate_main.cpp", "records/generate_main.cpp")
ANSWERS = re.compile(r"_main\.cpp$")


def faults_of(path, text):
    if path in MAY:
        return []
    faults = []
    for number, line in enumerate(text.splitlines(), start=1):
        found = PRINTS.search(line.split("//")[0])
        if not found or TO_STDERR_LITERAL.search(line):
            continue
        if ANSWERS.search(path) and "stderr" not in line and "cerr" not in line:
            continue
        faults.append(f"{path}:{number}: {found.group(1)}: print with app/commands/say.h")
    return faults


def check(root):
    files = sorted(file for folder in ("app", "importers", "records", "libdda") for file in (root / folder).rglob("*.cpp"))
    return len(files), [fault for file in files
                        for fault in faults_of(file.relative_to(root).as_posix(), file.read_text(encoding="utf-8"))]


def self_test():
    for path, line, bad in (("app/commands/run.cpp", 'fmt::print("{}\\n", title);', True),
                            ("app/commands/run.cpp", "std::cerr << title;", True),
                            ("app/commands/run.cpp", 'say(title);  // not fmt::print', False),
                            ("app/commands/say.cpp", "std::fwrite(text.data(), 1, text.size(), stdout);", False),
                            ("app/render/render_main.cpp", 'fmt::print("{}\\n", path);', False),
                            ("app/render/render_main.cpp", 'std::fprintf(stderr, "%s", error.what());', True)):
        if bool(faults_of(path, line)) != bad:
            sys.exit(f"self-test: {path}: {line}")
    print("planted faults are found")


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
        sys.exit()
    count, faults = check(Path(sys.argv[1] if len(sys.argv) > 1 else ".").resolve())
    print("\n".join(faults) if faults else f"{count} files print through one function")
    sys.exit(1 if faults else 0)
