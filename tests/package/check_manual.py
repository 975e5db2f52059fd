#!/usr/bin/env python3
"""Every command of the program has a manual page with all its options, and the shell completes them.

    check_manual.py PROGRAM REPOSITORY

The commands are taken from the source, not from the help that the manual is made of.
"""

import gzip
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path


def commands_of(repository):
    """The names given to add_subcommand in app/, by the program `voussoir`."""
    source = "".join(file.read_text() for file in sorted((repository / "app").rglob("*.cpp"))
                     if "generate" not in file.name and file.parent.name != "problems")
    return re.findall(r'add_subcommand\(\s*"([a-z-]+)"', source)


def options_of(program, command):
    help_ = subprocess.run([program, command, "--help"], check=True, capture_output=True, text=True).stdout
    return set(re.findall(r"^  (?:-\w,)?(--[a-z-]+)", help_, re.MULTILINE))


def completed(script, *words):
    """What bash offers for the last of the words."""
    before = words[-2]
    line = " ".join(f"'{word}'" for word in words)
    bash = (f"source {script}; COMP_WORDS=({line}); COMP_CWORD={len(words) - 1}; "
            f"_voussoir voussoir '{words[-1]}' '{before}'; printf '%s\\n' \"${{COMPREPLY[@]}}\"")
    return set(subprocess.run(["bash", "-c", bash], check=True, capture_output=True, text=True).stdout.split())


def check(faults, holds, sentence):
    if not holds:
        faults.append(sentence)


def check_page(faults, folder, program, command):
    page = folder / "man1" / f"voussoir-{command}.1.gz"
    if not page.is_file():
        return faults.append(f"no manual page voussoir-{command}")
    text = gzip.decompress(page.read_bytes()).decode().replace("\\-", "-")
    for option in options_of(program, command):
        check(faults, option in text, f"voussoir-{command}(1) does not tell of {option}")
    if shutil.which("groff"):
        warnings = subprocess.run(["groff", "-man", "-Tutf8", "-ww", "-z"], input=gzip.decompress(page.read_bytes()),
                                  capture_output=True, check=True).stderr.decode()
        check(faults, not warnings, f"voussoir-{command}(1): {warnings}")


def check_completions(faults, script, program, commands):
    offered = completed(script, "voussoir", "")
    for command in commands:
        check(faults, command in offered, f"the shell does not complete the command {command}")
        missing = options_of(program, command) - completed(script, "voussoir", command, "--")
        check(faults, not missing, f"the shell does not complete {sorted(missing)} of {command}")
    check(faults, completed(script, "voussoir", "run", "--res") == {"--resume"}, "run --res is not completed to --resume")
    check(faults, "node" in completed(script, "voussoir", "import", "--stones", ""), "the values of --stones are not offered")
    check(faults, not completed(script, "voussoir", "run", "cas"), "something is offered in the place of files")


def main():
    program, repository = sys.argv[1], Path(sys.argv[2])
    commands = commands_of(repository)
    faults = []
    check(faults, {"run", "check", "import"} <= set(commands), f"the source names only the commands {commands}")
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([repository / "scripts/make_manual.py", program, folder], check=True)
        check(faults, (Path(folder) / "man1/voussoir.1.gz").is_file(), "no manual page voussoir")
        for command in commands:
            check_page(faults, Path(folder), program, command)
        check_completions(faults, Path(folder) / "completions/voussoir", program, commands)
    print("\n".join(faults) or f"{len(commands)} commands, each with a manual page and completions")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
