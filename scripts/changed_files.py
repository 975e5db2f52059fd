#!/usr/bin/env python3
"""Names the C++ files that differ from another state of the repository, one a line.

    scripts/changed_files.py [--sources] [--at-most N] [BASE]
    scripts/changed_files.py --lines [BASE]
    scripts/changed_files.py --self-test

BASE is a commit; without one it is where this branch left origin/main, or the commit before the last one if it never
left. What is not committed yet counts as changed. With --sources a header stands for a source that includes it: its
own if it has one. With --at-most N no more than N are named, spread evenly over the list; how many are left out is
said on standard error. Without any history every file counts as changed. With --lines the lines that differ are
named instead, as clang-tidy takes them (--line-filter).
"""

import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

MODULES = ("libdda", "importers", "records", "app", "tests")
INCLUDE = re.compile(r'^\s*#\s*include\s*"([^"]+)"', re.MULTILINE)


def git(*arguments):
    """The lines git answers, or None if it fails."""
    done = subprocess.run(("git", *arguments), capture_output=True, text=True)
    return done.stdout.splitlines() if done.returncode == 0 else None


def default_base():
    """A commit, or None where there is no history."""
    head, left = git("rev-parse", "HEAD"), git("merge-base", "origin/main", "HEAD")
    if left and left != head:
        return left[0]
    before = git("rev-parse", "--verify", "HEAD~1")
    return before[0] if before else None


def cpp_files(names):
    return sorted({name for name in names if name.endswith((".h", ".cpp")) and name.startswith(MODULES)
                   and Path(name).is_file()})


def changed_since(base):
    if base is None:
        return cpp_files(git("ls-files"))
    # A file that only moved (R100) has not changed.
    differing = git("diff", "--name-status", "--find-renames", "--relative", base, "--")
    if differing is None:
        print(f"scripts/changed_files.py: {base} is no commit of this repository", file=sys.stderr)
        sys.exit(2)
    changed = [line.split("\t")[-1] for line in differing if not line.startswith("R100")]
    return cpp_files(changed + git("ls-files", "--others", "--exclude-standard"))


def changed_lines(base, files):
    """For each file the first and last lines of what differs in it; all of a file that is new."""
    lines = {path: [] for path in files}
    if base is not None:
        path = None
        for line in git("diff", "--unified=0", "--find-renames", "--relative", base, "--") or ():
            hunk = re.match(r"@@ -\S+ \+(\d+)(?:,(\d+))? @@", line)
            if line.startswith("+++ "):
                path = line[6:].rstrip("\t")
            elif hunk and path in lines and hunk.group(2) != "0":
                first = int(hunk.group(1))
                lines[path].append([first, first + int(hunk.group(2) or 1) - 1])
    tracked = set(git("ls-files")) if base is not None else set()
    return [{"name": path, "lines": ranges} if path in tracked else {"name": path}
            for path, ranges in lines.items() if ranges or path not in tracked]


def includers():
    """Of each file of ours, those that include it."""
    answer = {}
    for path in cpp_files(git("ls-files", "--cached", "--others", "--exclude-standard")):
        for included in INCLUDE.findall(Path(path).read_text(encoding="utf-8")):
            answer.setdefault(included, []).append(path)
    return answer


def source_of(header, including):
    """A source that includes the header, through as few other headers as can be; None if no source does."""
    own = header[:-2] + ".cpp"
    near, seen = [header], {header}
    while near:
        next_ring = [path for known in near for path in including.get(known, ()) if path not in seen]
        if own in next_ring:
            return own
        sources = sorted(path for path in next_ring if path.endswith(".cpp"))
        if sources:
            return sources[0]
        seen.update(next_ring)
        near = next_ring
    return None


def as_sources(files):
    including = includers()
    sources = {path: source_of(path, including) if path.endswith(".h") else path for path in files}
    for path in (path for path in files if sources[path] is None):
        print(f"{path}: no source includes it; it is left out", file=sys.stderr)
    return sorted({source for source in sources.values() if source})


def spread(files, most):
    if most is None or len(files) <= most:
        return files
    print(f"{len(files)} files changed; {most} of them, spread evenly, are looked at and {len(files) - most} are not",
          file=sys.stderr)
    return [files[i * len(files) // most] for i in range(most)]


def self_test():
    """In a repository of its own: a header that moves, one that changes, a source that is new."""
    if shutil.which("git") is None:
        print("skipped: git is not installed")
        sys.exit(77)
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        for path, text in (("libdda/own.h", "// own"), ("libdda/own.cpp", '#include "libdda/own.h"'),
                           ("libdda/far.h", "// far"), ("libdda/near.h", '#include "libdda/far.h"'),
                           ("app/user.cpp", '#include "libdda/near.h"'), ("app/same.h", "// moves\n" * 9)):
            Path(path).parent.mkdir(exist_ok=True)
            Path(path).write_text(text + "\n", encoding="utf-8")
        for command in (("init", "-q"), ("add", "."),
                        ("-c", "user.name=a", "-c", "user.email=a@b.c", "commit", "-qm", "all")):
            assert git(*command) is not None, command
        assert changed_since("HEAD") == [] and default_base() is None
        Path("libdda/own.h").write_text("// other\n", encoding="utf-8")
        Path("libdda/far.h").write_text("// farther\n", encoding="utf-8")
        Path("app/new.cpp").write_text("\n", encoding="utf-8")
        git("mv", "app/same.h", "app/moved.h")
        changed = changed_since("HEAD")
        assert changed_lines("HEAD", changed) == [
            {"name": "app/new.cpp"}, {"name": "libdda/far.h", "lines": [[1, 1]]},
            {"name": "libdda/own.h", "lines": [[1, 1]]}], changed_lines("HEAD", changed)
        assert changed == ["app/new.cpp", "libdda/far.h", "libdda/own.h"], changed
        assert as_sources(changed) == ["app/new.cpp", "app/user.cpp", "libdda/own.cpp"], as_sources(changed)
        assert spread(list("abcdef"), 3) == ["a", "c", "e"]
    print("changed files are found")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--sources", action="store_true")
    parser.add_argument("--at-most", type=int, metavar="N")
    parser.add_argument("base", nargs="?", metavar="BASE")
    parser.add_argument("--lines", action="store_true")
    parser.add_argument("--self-test", action="store_true")
    arguments = parser.parse_args()
    if arguments.self_test:
        self_test()
        return
    base = arguments.base or default_base()
    files = changed_since(base)
    if arguments.lines:
        print(json.dumps(changed_lines(base, files)))
        return
    if arguments.sources:
        # The fuzz targets are built by another preset.
        files = [path for path in as_sources(files) if not path.startswith("tests/fuzz/")]
    for path in spread(files, arguments.at_most):
        print(path)


if __name__ == "__main__":
    os.chdir(Path(__file__).resolve().parent.parent)
    main()
