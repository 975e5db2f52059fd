#!/usr/bin/env python3
"""Writes the manual pages and the shell completions of the program, from what its --help says.

    scripts/make_manual.py PROGRAM FOLDER   FOLDER/man1/voussoir.1.gz, voussoir-run.1.gz, ...; FOLDER/completions/voussoir

Exit code 1 when the help is not laid out as CLI11 does it: nothing is guessed.
"""

import gzip
import re
import subprocess
import sys
from dataclasses import dataclass, field
from pathlib import Path

COLUMN = 30  # where CLI11 puts what an entry is for


@dataclass
class Help:
    """What --help says: a sentence, the usage, entries (name, meaning) by section, what stands below."""
    sentence: str = ""
    usage: str = ""
    sections: dict = field(default_factory=dict)
    footer: list = field(default_factory=list)


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def split_entry(line, following):
    """The name and the meaning of an entry; a long name has its meaning in the line below."""
    if following.startswith(" " * COLUMN):
        return line.strip(), ""
    if len(line) <= COLUMN or line[COLUMN - 1] != " ":
        raise ValueError(f"an entry of the help without a meaning: {line!r}")
    return line[:COLUMN].strip(), line[COLUMN:].strip()


def parse_help(text):
    lines = text.splitlines() + [""]
    result = Help(sentence=lines[0])
    section = None
    for line, following in zip(lines[1:], lines[2:] + [""]):
        if line.startswith("Usage: "):
            result.usage = line.removeprefix("Usage: ")
        elif re.fullmatch(r"[A-Z]\w+:", line):
            section = result.sections.setdefault(line[:-1], [])
        elif not line.strip():
            section = None
        elif section is None:
            result.footer.append(line)
        elif line.startswith(" " * COLUMN):
            name, meaning = section[-1]
            section[-1] = name, f"{meaning} {line.strip()}".strip()
        else:
            section.append(split_entry(line, following))
    if not result.usage or "Options" not in result.sections:
        raise ValueError(f"this is no help as CLI11 writes it: {text[:200]!r}")
    return result


def escaped(text):
    """Text that roff takes literally: a hyphen stays one, and no line begins with a command."""
    text = text.replace("\\", "\\e").replace("-", "\\-")
    return "\\&" + text if text.startswith((".", "'")) else text


def manual_page(title, help_, version, see_also):
    lines = [f'.TH "{title.upper()}" 1 "" "{version}" "voussoir"', ".SH NAME",
             f"{escaped(title)} \\- {escaped(help_.sentence)}", ".SH SYNOPSIS", f".B {escaped(help_.usage)}"]
    for section, entries in help_.sections.items():
        lines.append(f".SH {section.upper()}")
        for name, meaning in entries:
            lines += [".TP", f".B {escaped(name)}", escaped(meaning)]
    if help_.footer:
        lines.append(".SH EXIT STATUS")
        lines += [escaped(line.removeprefix("Exit codes: ")) for line in help_.footer]
    lines += [".SH SEE ALSO", ", ".join(f"\\fB{escaped(page)}\\fR(1)" for page in see_also)]
    return "\n".join(lines) + "\n"


def spellings(name):
    """The options an entry names: "-o,--output DIR" gives -o and --output."""
    return [word for word in name.split(" ")[0].split(",") if word.startswith("-")]


def values(name):
    """What an option may be, where its help lists it: "--up CHAR:{x,y,z}"."""
    listed = re.search(r":\{([^}]*)\}", name)
    return listed.group(1).replace(",", " ") if listed else ""


def completions(program_help, commands):
    first = [name for name in commands] + [word for name, _ in program_help.sections["Options"]
                                           for word in spellings(name)]
    lines = ["# bash completion of voussoir, made by scripts/make_manual.py", "_voussoir()", "{",
             "    local word=$2 previous=$3 words=",
             f"    if [ \"$COMP_CWORD\" = 1 ]; then words='{' '.join(first)}'; else", '        case "${COMP_WORDS[1]} $word" in']
    for command, help_ in commands.items():
        options = [word for name, _ in help_.sections["Options"] for word in spellings(name)]
        lines.append(f"            '{command} '-*) words='{' '.join(options)}' ;;")
    lines += ["        esac", '        case "${COMP_WORDS[1]} $previous" in']
    for command, help_ in commands.items():
        for name, _ in help_.sections["Options"]:
            if values(name):
                lines.append(f"            '{command} {spellings(name)[-1]}') words='{values(name)}' ;;")
    lines += ["        esac", "    fi", "    # Nothing of ours: readline completes names of files.",
              '    COMPREPLY=($(compgen -W "$words" -- "$word"))', "}", "complete -o default -F _voussoir voussoir"]
    return "\n".join(lines) + "\n"


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    program, folder = sys.argv[1], Path(sys.argv[2])
    try:
        program_help = parse_help(output_of(program, "--help"))
        commands = {name: parse_help(output_of(program, name, "--help"))
                    for name, _ in program_help.sections["Subcommands"]}
    except (ValueError, KeyError, OSError, subprocess.CalledProcessError) as error:
        sys.exit(f"scripts/make_manual.py: {error}")
    version = output_of(program, "--version").splitlines()[0]
    pages = {"voussoir": program_help, **{f"voussoir-{name}": help_ for name, help_ in commands.items()}}
    (folder / "man1").mkdir(parents=True, exist_ok=True)
    (folder / "completions").mkdir(exist_ok=True)
    for old in (folder / "man1").glob("voussoir*.1.gz"):  # of a command that is no more
        old.unlink()
    for title, help_ in pages.items():
        see_also = [page for page in pages if page != title] if title == "voussoir" else ["voussoir"]
        page = manual_page(title, help_, version, see_also)
        # Without a time stamp: the same program has the same pages, byte for byte.
        (folder / "man1" / f"{title}.1.gz").write_bytes(gzip.compress(page.encode(), mtime=0))
    (folder / "completions" / "voussoir").write_text(completions(program_help, commands))


if __name__ == "__main__":
    main()
