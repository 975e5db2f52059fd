#!/usr/bin/env python3
"""Holds one style of test names: TEST(CamelCaseSuite, CamelCaseSentence), each name once in its suite and file.

    scripts/check_test_names.py             checks tests/; exit code 1 and one line per fault
    scripts/check_test_names.py --fix       renames snake_case names in place
    scripts/check_test_names.py --self-test plants faults and sees that they are found and mended
"""

import re
import sys
from pathlib import Path

TEST = re.compile(r"^(\s*(?:TYPED_)?TEST(?:_F|_P)?\(\s*)(\w+)(,\s*)(\w+)(?=\))", re.MULTILINE)
CAMEL = re.compile(r"[A-Z][A-Za-z0-9]*")


def camel(name):
    """a_block_of_2_stones as ABlockOf2Stones."""
    return "".join(word[:1].upper() + word[1:] for word in name.split("_"))


def faults_of(path, text):
    faults, seen = [], set()
    for match in TEST.finditer(text):
        suite, name = match.group(2), match.group(4)
        place = f"{path}:{text.count(chr(10), 0, match.start(2)) + 1}: {suite}.{name}"
        if not (CAMEL.fullmatch(suite) and CAMEL.fullmatch(name)):
            faults.append(f"{place}: write {camel(suite)}, {camel(name)}")
        if (suite, camel(name)) in seen:
            faults.append(f"{place}: its suite has this name already")
        seen.add((suite, camel(name)))
    return faults


def fixed(text):
    """Suites are left as they are: a class carries their name."""
    return TEST.sub(lambda match: "".join((*match.groups()[:3], camel(match.group(4)))), text)


def self_test():
    wrong = "TEST(Suite, a_block_rests)\nTEST_F(Suite, ABlockRests)\nTEST(suite_of, Rests)\n"
    mended = "TEST(Suite, ABlockRests)\nTEST_P(Suite, Has2Stones)\n"
    found = faults_of("a", wrong)
    assert [fault.split(": ")[0] for fault in found] == ["a:1", "a:2", "a:3"], found
    assert faults_of("a", mended) == []
    assert fixed("TEST(Suite, a_block_rests)\nTEST_P(Suite, has_2_stones)\n") == mended
    print("names of tests judged rightly")


def main(arguments):
    if arguments == ["--self-test"]:
        self_test()
        return 0
    root = Path(__file__).resolve().parent.parent
    count, faults = 0, []
    for path in sorted((root / "tests").rglob("*.cpp")):
        text = path.read_text(encoding="utf-8")
        if arguments == ["--fix"] and fixed(text) != text:
            text = fixed(text)
            path.write_text(text, encoding="utf-8")
        count += len(TEST.findall(text))
        faults += faults_of(path.relative_to(root).as_posix(), text)
    if count == 0:
        faults.append("no tests found")
    for fault in faults:
        print(fault)
    if not faults:
        print(f"{count} tests are named in one style")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
