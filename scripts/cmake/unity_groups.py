#!/usr/bin/env python3
"""Which sources of a target may be compiled as one: no two of a group give the same name to something of their own.

    scripts/cmake/unity_groups.py MOST LIST      LIST has lines TARGET SOURCE; prints TARGET GROUP SOURCE for all that share
                                                 a group with others, MOST of them at most
    scripts/cmake/unity_groups.py --self-test    plants what must not meet and sees that it does not

What stands in an unnamed namespace is a source's own, and so are macros that it leaves defined. A name of its own that a
header has too, one that another of the group includes and it does not, would be taken for that one. A source is put into
the first group that has room and nobody it would be mistaken for: most of those listed together stay together.
"""

import functools
import re
import sys
import tempfile
from collections import Counter
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent

TYPE = re.compile(r"(?:template <.*> )?(?:struct|class|enum class|enum|union|concept) (?:\[\[\w+\]\] )?(\w+)")
NAME = re.compile(r"(\w+)$")
INCLUDED = re.compile(r'#include "(.+)"')
ALIAS = re.compile(r"using (\w+) = .*;$")  # whole: the same one twice is the same type
USED = re.compile(r"using (?!namespace )(?:\w+::)+(\w+);")
MACRO = re.compile(r"#\s*(define|undef)\s+(\w+)")
RAW_STRING = re.compile(r'R"(\w*)\(.*?\)\1"', re.DOTALL)
NO_NAMES = re.compile(r"[{}\s/#*&)\]]|(?:using|template|namespace)\b|[A-Z_]+\(")


def declared_on(line):
    """The names that a line at the margin declares: what stands before its first bracket or sign, and before those after
    a comma where that is a variable."""
    if kind := TYPE.match(line):
        return {kind.group(1)}
    if alias := re.match(r"using (\w+) =", line):
        return {alias.group(1)}
    if NO_NAMES.match(line):
        return set()
    depth, start, awaited, names = 0, 0, True, set()
    for index, sign in enumerate(line):
        if awaited and depth == 0 and sign in "({=;[":
            names |= set(NAME.findall(line[start:index].rstrip()))
            awaited = False
            if sign == "(":
                return names
        if depth == 0 and sign == ",":
            start, awaited = index + 1, True
        depth += {"<": 1, "(": 1, "{": 1, "[": 1, ">": -1, ")": -1, "}": -1, "]": -1}.get(sign, 0)
    return names


def own_names(text):
    """Of a source: what its unnamed namespaces declare, what it takes from other namespaces, and the macros that it leaves
    defined."""
    names, used, macros, unnamed = set(), set(), set(), False
    for line in RAW_STRING.sub('""', text).splitlines():
        if macro := MACRO.match(line):
            (macros.add if macro.group(1) == "define" else macros.discard)(macro.group(2))
        elif taken := USED.match(line):
            used.add(taken.group(1))
        elif line == "namespace":
            unnamed = True
        elif line == "}  // namespace":
            unnamed = False
        elif unnamed:
            names |= declared_on(line)
    return names, used, macros


def headers_of(text):
    """Our own that a source includes, and what those include."""
    found, waiting = set(), INCLUDED.findall(text)
    while waiting:
        header = waiting.pop()
        if header not in found and (ROOT / header).is_file():
            found.add(header)
            waiting += INCLUDED.findall((ROOT / header).read_text(encoding="utf-8"))
    return found


@functools.cache
def names_of_header(header):
    lines = RAW_STRING.sub('""', (ROOT / header).read_text(encoding="utf-8")).splitlines()
    return set().union(*map(declared_on, lines))


class Source:
    """What of a source another one would see, and what it has of headers."""

    def __init__(self, path):
        text = Path(path).read_text(encoding="utf-8")
        self.names, self.used, self.macros = own_names(text)
        self.aliases = {line for line in text.splitlines() if ALIAS.match(line)}
        self.headers = headers_of(text)

    def would_mistake(self, other):
        """Whether a name of this source is one that the other declares, uses or brings in with a header."""
        brought = set().union(*map(names_of_header, other.headers - self.headers))
        same = {ALIAS.match(line).group(1) for line in self.aliases & other.aliases}
        return bool((self.names - same) & other.names or self.names & (other.used | brought))

    def meets(self, other):
        return self.would_mistake(other) or other.would_mistake(self)


def groups(sources, most):
    """Pairs of a group's number and a source; whoever leaves a macro defined has a group for itself."""
    found = []  # of each group: its sources
    for path in sources:
        source = Source(path)
        place = next((index for index, group in enumerate(found)
                      if len(group) < most and not source.macros and not group[0].macros
                      and not any(map(source.meets, group))), len(found))
        if place == len(found):
            found.append([])
        found[place].append(source)
        yield place, path


def self_test():
    own = "namespace a\n{\n\nnamespace\n{\n\n"
    end = "\n}  // namespace\n\n}  // namespace a\n"
    texts = {
        "first.cpp": own + "double width_of(const std::map<int, Pair>& block)\n{\n    return 1;\n}\nconst double h{1}, g = 9.81;  // m, m/s2" + end
        + "#include \"libdda/errors.h\"\n",
        "second.cpp": own + "struct Side\n{\n    double width_of;\n};\nusing Row = std::vector<double>;" + end,
        "eleventh.cpp": own + "using Row = std::vector<double>;" + end,
        "ninth.cpp": own + "struct InputError\n{\n};" + end,  # libdda/errors.h has it, which the first includes
        "third.cpp": own + "constexpr std::array<double, 2> g{1, 2};" + end,
        "fourth.cpp": own + "class Side;\ntemplate <class T>\nvoid swap_all(T& one)\n{\n}" + end,
        "fifth.cpp": "#define LOUD\n",
        "sixth.cpp": "#define QUIET\n#undef QUIET\n" + own + "template <class T> struct Row;" + end,
        "seventh.cpp": "namespace a\n{\n\nusing b::g;\nusing b::h;\n\n}  // namespace a\n",
        "eighth.cpp": "namespace a\n{\n\ndouble g();\n\n}  // namespace a\n",
        "tenth.cpp": own + "double h;" + end,
    }
    expected = {"first.cpp": 0, "second.cpp": 0, "eleventh.cpp": 0, "ninth.cpp": 1, "third.cpp": 1, "fourth.cpp": 1,
                "fifth.cpp": 2, "sixth.cpp": 3, "seventh.cpp": 3, "eighth.cpp": 3, "tenth.cpp": 4}
    with tempfile.TemporaryDirectory() as folder:
        for name, text in texts.items():
            (Path(folder) / name).write_text(text, encoding="utf-8")
        found = {Path(source).name: group for group, source in groups([Path(folder) / name for name in texts], 3)}
    if found != expected:
        sys.exit(f"unity_groups: sources are grouped as {found}, must be {expected}")
    print("unity_groups: what must not meet does not")


if __name__ == "__main__":
    if sys.argv[1:] == ["--self-test"]:
        self_test()
    else:
        targets = {}
        for line in Path(sys.argv[2]).read_text(encoding="utf-8").splitlines():
            target, path = line.split(" ", 1)
            targets.setdefault(target, []).append(path)
        for target, paths in targets.items():
            found = list(groups(paths, int(sys.argv[1])))
            sizes = Counter(number for number, _ in found)
            for number, path in found:
                if sizes[number] > 1:
                    print(f"{target} {number} {path}")
