#!/usr/bin/env python3
"""The installed headers: listed, each compiles alone without the repository, and nothing private is among them.

    check_headers.py PREFIX COMPILER EIGEN
"""

import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

SURFACES = {"voussoir.h": "libdda", "records.h": "records", "importers.h": "importers"}  # what each may bring along
PRIVATE = ("solve/", "step/step_system.h", "step/contact_step.h", "step/block_step.h", "contact/", "formats/")


def compile_alone(include, compiler, eigen, header):
    """The compiler's complaints about a program that includes nothing but this header, by its installed path."""
    command = [compiler, "-std=c++20", "-fsyntax-only", "-Wall", "-Wextra", "-Werror", "-x", "c++", "-",
               "-DEIGEN_MAX_ALIGN_BYTES=32", "-DEIGEN_MAX_STATIC_ALIGN_BYTES=32",
               f"-I{include}", f"-I{include}/voussoir", f"-isystem{eigen}"]
    result = subprocess.run(command, input=f"#include <{header}>\n", capture_output=True, text=True, check=False)
    return f"{header} does not compile alone:\n{result.stderr}" if result.returncode else ""


def main():
    prefix, compiler, eigen = Path(sys.argv[1]), sys.argv[2], sys.argv[3]
    include = prefix / "include"
    headers = sorted(str(file.relative_to(include)) for file in include.rglob("*") if file.is_file())
    print("\n".join(headers))
    faults = [f"{header} is private and must not be installed" for header in headers
              if any(part in header for part in PRIVATE)]
    for surface, room in SURFACES.items():
        if f"voussoir/{surface}" not in headers and surface != "importers.h":
            faults.append(f"<voussoir/{surface}> is not installed")
    rooms = tuple(f"voussoir/{room}/" for room in SURFACES.values())
    faults += [f"{header} stands in no room of a library" for header in headers
               if not header.startswith(rooms) and header.removeprefix("voussoir/") not in SURFACES]
    with ThreadPoolExecutor(2) as pool:
        faults += filter(None, pool.map(lambda header: compile_alone(include, compiler, eigen, header), headers))
    print("\n".join(faults) or f"{len(headers)} headers, each compiles alone")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
