#!/usr/bin/env python3
"""Holds the rule of pictures: pages keep tables and one small picture each; full figures are made by commands.

    scripts/check_figures.py [ROOT]      checks what git tracks; exit code 1 and one line per fault
    scripts/check_figures.py --self-test plants one fault of each kind and sees that it is found

A picture is tracked if a page shows it, or if a test compares with it (GOLDEN). It is below a limit of size. A page shows
one picture (MORE names the exceptions), and every picture it shows is tracked. scripts/small_picture makes pictures small.
"""

import posixpath
import re
import subprocess
import sys
import tempfile
from pathlib import Path

LIMIT = 120_000  # bytes of a picture on a page
GOLDEN = {"tests/app/render/golden/": 5_000}  # folders of pictures that tests compare with; bytes of each picture
PLACES = ("docs/",)  # where pictures of pages lie
MORE = {"README.md": 3}  # pages that show more than one picture

ENDING = r"\.(?:png|svg|jpe?g|gif|webp|pdf)"
PICTURE = re.compile(ENDING + r"$", re.IGNORECASE)
# [words](picture), with or without the ! that shows it, and <img src="picture">; not those of other sites.
LINK = re.compile(r"\]\(<?([^()\s>]+?" + ENDING + r")>?(?:\s+\"[^\"]*\")?\)|<img\b[^>]*?\bsrc=\"([^\"]+)\"", re.IGNORECASE)
CODE = re.compile(r"^```.*?^```|`[^`\n]*`", re.MULTILINE | re.DOTALL)


def links_of(text):
    """The pictures of this repository that a page links, as written."""
    found = [first or second for first, second in LINK.findall(CODE.sub("", text))]
    return [link for link in found if "://" not in link]


def faults_of_pages(pages, pictures):
    """Faults of the pages as lines. @param pages texts by path; @param pictures paths. Also returns what is shown."""
    faults, shown = [], set()
    for page, text in sorted(pages.items()):
        links = links_of(text)
        allowed = MORE.get(page, 1)
        if len(links) > allowed:
            faults.append(f"{page}: {len(links)} pictures, at most {allowed}: name the command that makes the others")
        for link in links:
            path = posixpath.normpath(posixpath.join(posixpath.dirname(page), link))
            if path not in pictures:
                faults.append(f"{page}: {link} is not tracked")
            shown.add(path)
    return faults, shown


def faults_of_picture(path, size, shown):
    golden = next((folder for folder in GOLDEN if path.startswith(folder)), None)
    limit = GOLDEN.get(golden, LIMIT)
    if size > limit:
        yield f"{path}: {size} bytes, at most {limit}: scripts/small_picture"
    if golden is None and not path.startswith(PLACES):
        yield f"{path}: pictures lie in {' or '.join((*PLACES, *GOLDEN))}"
    elif golden is None and path not in shown:
        yield f"{path}: no page shows it"


def check(root, tracked):
    """@param tracked paths, relative to root. @returns the number of pictures, and faults as lines"""
    there = [path for path in tracked if (root / path).is_file()]  # not what is about to be removed
    sizes = {path: (root / path).stat().st_size for path in there if PICTURE.search(path)}
    pages = {path: (root / path).read_text(encoding="utf-8") for path in there if path.endswith(".md")}
    faults, shown = faults_of_pages(pages, sizes)
    for path, size in sorted(sizes.items()):
        faults += faults_of_picture(path, size, shown)
    return len(sizes), faults


def tracked_in(root):
    """Paths that git tracks; none where this is no checkout."""
    listed = subprocess.run(["git", "-C", root, "ls-files", "-z"], capture_output=True, text=True, check=False)
    return [] if listed.returncode else [path for path in listed.stdout.split("\0") if path]


GOOD = {"docs/a.md": "![A picture\nof something](figures/a.png)\n", "docs/figures/a.png": "",
        "tests/app/render/golden/b.png": ""}
# what: files beside those that are right, bytes of docs/figures/a.png, and the beginning of the one fault, or None
PLANTED = (
    ("as it must be", {}, LIMIT, None),
    ("too large", {}, LIMIT + 1, "docs/figures/a.png: 120001 bytes"),
    ("a golden picture that is too large", {"tests/app/render/golden/b.png": 6_000 * "x"}, 9, "tests/app/render/golden/b.png: 6000"),
    ("two on one page", {"docs/b.md": "[1](figures/a.png) ![2](figures/a.png)"}, 9, "docs/b.md: 2 pictures, at most 1"),
    ("three on the first page", {"README.md": 3 * "![1](docs/figures/a.png)"}, 9, None),
    ("four on the first page", {"README.md": 4 * "![1](docs/figures/a.png)"}, 9, "README.md: 4 pictures, at most 3"),
    ("a link to nothing", {"docs/b.md": "![1](a.png)"}, 9, "docs/b.md: a.png is not tracked"),
    ("an image to nothing", {"docs/b.md": '<img width="9" src="a.svg">'}, 9, "docs/b.md: a.svg is not tracked"),
    ("a link out of a folder", {"docs/parts/b.md": "![1](../figures/a.png)"}, 9, None),
    ("names in code", {"docs/b.md": "`![1](a.png)` and\n```\n![1](b.png)\n```\n"}, 9, None),
    ("of another site", {"docs/b.md": "![1](https://example.org/a.png)"}, 9, None),
    ("shown nowhere", {"docs/figures/b.JPG": ""}, 9, "docs/figures/b.JPG: no page shows it"),
    ("in another folder", {"cases/b.svg": ""}, 9, "cases/b.svg: pictures lie in"),
)


def self_test():
    for what, files, size, expected in PLANTED:
        with tempfile.TemporaryDirectory() as name:
            root = Path(name)
            for path, text in {**GOOD, **files}.items():
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text(size * "x" if path == "docs/figures/a.png" else text, encoding="utf-8")
            count, faults = check(root, [*GOOD, *files, "docs/removed.png"])
            right = not faults if expected is None else len(faults) == 1 and faults[0].startswith(expected)
            if not right or count < 2:
                sys.exit(f"self-test: {what}: expected {expected}, found {faults}")
    print(f"{len(PLANTED)} planted sets of files judged rightly")


def main(arguments):
    if arguments == ["--self-test"]:
        self_test()
        return 0
    root = Path(arguments[0] if arguments else ".").resolve()
    tracked = tracked_in(root)
    if not tracked:
        print(f"{root}: not a git checkout")
        return 77  # to ctest: skipped
    count, faults = check(root, tracked)
    print("\n".join(faults) if faults else f"{count} pictures are small, and each page shows few")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
