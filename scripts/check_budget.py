#!/usr/bin/env python3
"""Holds the engine's step to a budget of lines and constants.

    scripts/check_budget.py [ROOT]      prints what each room has and what it may have; exit code 1 beyond that
    scripts/check_budget.py --self-test plants lines and constants and sees that they are counted

A line is one of code: not blank, not a comment. A constant is any literal number but 0, 1, 2 and 1/2, in code or as a default;
what stands in angle brackets alone (Vector<3>) is a dimension and none. Who needs more than a room has takes something out
first, or says in the commit why the budget grows.
"""

import re
import sys
from pathlib import Path

# Room of libdda: lines, constants.
BUDGET = {
    "block": (944, 7),
    "forces": (2367, 18),
    "problem": (438, 2),
    "iterate": (825, 17),
    "impact": (750, 13),
    "step": (751, 1),
}
LITERAL = re.compile(r"(?<![\w.])(?:0x[0-9a-fA-F]+|\d[\d']*\.?\d*(?:[eE][+-]?\d+)?|\.\d+(?:[eE][+-]?\d+)?)[uUlLfFzZ]*(?![\w.])")
FREE = (0, 1, 2, 0.5)


def code_of(text):
    """Without comments, texts and preprocessor lines."""
    text = re.sub(r"//[^\n]*", "", text)
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL)
    text = re.sub(r'"(?:\\.|[^"\\])*"', '""', text)
    return re.sub(r"^\s*#.*$", "", text, flags=re.MULTILINE)


def count(text):
    """Lines of code, and the constants among them."""
    code = code_of(text)
    lines = sum(1 for line in code.splitlines() if line.strip())
    without_dimensions = re.sub(r"<\s*\d+(\s*,\s*-?\d+)*\s*>", "<>", code)
    values = [match.group(0).rstrip("uUlLfFzZ").replace("'", "") for match in LITERAL.finditer(without_dimensions)]
    return lines, [value for value in values if value.startswith("0x") or float(value) not in FREE]


def check(root):
    faults = []
    for room, (most_lines, most_constants) in BUDGET.items():
        counts = [count(file.read_text(encoding="utf-8")) for file in sorted((root / "libdda" / room).glob("*"))]
        lines, constants = sum(one[0] for one in counts), sum(len(one[1]) for one in counts)
        print(f"libdda/{room}: {lines} lines of {most_lines}, {constants} constants of {most_constants}")
        if lines > most_lines or constants > most_constants:
            faults.append(f"libdda/{room} is beyond its budget")
    return faults


def self_test():
    planted = ("// 7 is none\nconstexpr double a = 0.3;  // one\n\nVectorIn<3> b = 2 * c[0] + 0.5;\nint d = 1'000, e = 1e-3;\n"
               'const char* f = "9";\n#define G 8\n')
    lines, constants = count(planted)
    return [] if (lines, constants) == (4, ["0.3", "1000", "1e-3"]) else [f"counted {lines} lines and {constants}"]


def main():
    faults = self_test() if "--self-test" in sys.argv[1:] else check(Path(sys.argv[1] if len(sys.argv) > 1 else "."))
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
