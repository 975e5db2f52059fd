#!/usr/bin/env python3
"""Holds the rules of who may include whom.

    scripts/check_includes.py [ROOT]      checks the repository; exit code 1 and one line per fault
    scripts/check_includes.py --self-test plants one fault of each kind and sees that it is found
"""

import re
import sys
import tempfile
from pathlib import Path

MODULES = ("libdda", "importers", "records", "app", "tests")

# What files of a module may include from the repository, by the beginning of the path.
PROJECT_RULES = {
    "libdda/": ("libdda/",),
    "importers/": ("importers/", "libdda/geometry/", "libdda/errors.h"),
    "records/": ("records/", "libdda/model/ground_motion.h", "libdda/model/standard_gravity.h", "libdda/errors.h"),
    "app/": ("app/", "importers/", "records/", "libdda/"),
    "tests/": ("tests/", "app/", "importers/", "records/", "libdda/"),
}

# Foreign libraries: how their includes look, the folders that may include them, and whether headers may.
# A test may use the library of the module it tests.
FOREIGN_RULES = (
    ("Eigen", r"(unsupported/)?Eigen/", ("libdda/", "importers/", "records/", "app/", "tests/"), True),
    ("GoogleTest", r"g(test|mock)/", ("tests/",), True),
    ("SuiteSparse", r"(suitesparse/|cholmod|umfpack|amd|camd|colamd|ccolamd|SuiteSparse)", ("libdda/solve/",), False),
    ("OpenMP", r"omp\.h$", ("libdda/",), False),
    ("assimp", r"assimp/", ("importers/mesh/",), False),
    ("CGAL", r"(CGAL/|boost/|gmp|mpfr)", ("importers/exact/",), False),
    ("yaml-cpp", r"yaml-cpp/", ("app/case/",), False),
    ("HDF5", r"(hdf5|H5)", ("app/results/",), False),
    ("Cairo", r"cairo", ("app/render/", "app/plots/"), False),
    ("OSMesa, OpenGL, PNG", r"(GL/|EGL/|png\.h|ft2build|freetype)", ("app/render/",), False),
    ("pugixml", r"pugixml\.hpp$", ("importers/mesh/", "records/formats/"), False),
    ("libzip", r"zip\.h$", ("importers/mesh/",), False),
    ("zlib", r"zlib\.h$", ("records/", "tests/"), False),
    ("libmseed", r"libmseed\.h$", ("records/formats/",), False),
    ("FFTW", r"fftw3\.h$", ("records/",), False),
    ("nlohmann-json", r"nlohmann/", ("app/", "importers/mesh/", "tests/"), False),
    ("fmt", r"fmt/", ("app/",), False),
    ("CLI11", r"CLI/", ("app/",), False),
)
TESTS_OF = {"libdda/solve/": ("tests/libdda",), "libdda/": ("tests/libdda",),
            "importers/mesh/": ("tests/importers",), "importers/exact/": ("tests/importers",),
            "app/case/": ("tests/app",), "app/results/": ("tests/app", "tests/verification"),
            "app/render/": ("tests/app",), "app/verify/": ("tests/app_verify",), "app/": ("tests/app", "tests/verification")}

# The system's own headers beside those of the C++ standard (which have no slash and no ".h").
POSIX = re.compile(r"(sys/.*|unistd|fcntl|getopt|spawn|poll|signal|pthread|dlfcn|fenv|ftw|termios|time)\.h$")

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
OPENMP_PRAGMA = re.compile(r"^\s*#\s*pragma\s+omp\b")


def foreign_fault(path, included):
    """The fault of including a system or foreign header from `path`, or None."""
    for library, pattern, folders, headers_may in FOREIGN_RULES:
        if not re.match(pattern, included):
            continue
        allowed = folders + tuple(test for folder in folders for test in TESTS_OF.get(folder, ()))
        if not path.startswith(allowed):
            return f"<{included}>: {library} may be included only in {', '.join(folders)}"
        if not headers_may and path.endswith(".h") and not path.startswith("tests/"):
            return f"<{included}>: {library} may be included in .cpp files only, never in a header"
        return None
    if POSIX.match(included) or re.fullmatch(r"[a-z_0-9]+", included):
        return None
    return f"<{included}>: not a header we know; add its library to FOREIGN_RULES of scripts/check_includes.py"


def project_fault(root, path, included):
    """The fault of including our own header from `path`, or None."""
    if not (root / included).is_file():
        return f'"{included}": no such file; write the path from the repository root'
    module = path.split("/")[0] + "/"
    allowed = PROJECT_RULES[module]
    # Another module's .cpp is nobody's to include.
    if not included.endswith(".h"):
        return f'"{included}": only headers are included'
    if not included.startswith(allowed):
        return f'"{included}": {module} may include only {", ".join(allowed)}'
    return None


def faults_of_file(root, path):
    faults = []
    text = (root / path).read_text(encoding="utf-8")
    for number, line in enumerate(text.splitlines(), start=1):
        fault = None
        match = INCLUDE.match(line)
        if match and match.group(1) == "<":
            fault = foreign_fault(path, match.group(2))
        elif match:
            fault = project_fault(root, path, match.group(2))
        elif OPENMP_PRAGMA.match(line) and not path.startswith(("libdda/", "tests/libdda")):
            fault = "OpenMP may be used only in libdda/"
        if fault:
            faults.append(f"{path}:{number}: {fault}")
    return faults


def check(root):
    files = sorted(file.relative_to(root).as_posix() for module in MODULES if (root / module).is_dir()
                   for file in (root / module).rglob("*") if file.suffix in (".h", ".cpp"))
    return len(files), [fault for path in files for fault in faults_of_file(root, path)]


# path, line, and whether the line is a fault
PLANTED = (
    ("libdda/step/a.cpp", '#include "app/case/case_file.h"', True),
    ("libdda/step/b.cpp", '#include "libdda/errors.h"', False),
    ("libdda/step/c.cpp", "#include <cholmod.h>", True),
    ("libdda/solve/d.cpp", "#include <cholmod.h>", False),
    ("libdda/solve/d.h", "#include <suitesparse/cholmod.h>", True),
    ("libdda/solve/e.cpp", "#include <fmt/core.h>", True),
    ("libdda/solve/f.cpp", "#pragma omp parallel for", False),
    ("importers/mesh/a.cpp", "#include <assimp/scene.h>", False),
    ("importers/mesh/a.h", "#include <assimp/scene.h>", True),
    ("importers/mesh/b.cpp", "#include <CGAL/Surface_mesh.h>", True),
    ("importers/mesh/d.cpp", "#include <pugixml.hpp>", False),
    ("importers/mesh/d.h", "#include <zip.h>", True),
    ("records/formats/f.cpp", "#include <pugixml.hpp>", False),
    ("records/formats/f.h", "#include <pugixml.hpp>", True),
    ("records/g.cpp", "#include <pugixml.hpp>", True),
    ("importers/exact/e.cpp", "#include <nlohmann/json.hpp>", True),
    ("importers/mesh/c.cpp", '#include "libdda/model/model.h"', True),
    ("importers/exact/d.cpp", '#include "libdda/geometry/moments.h"', False),
    ("records/a.cpp", '#include "libdda/model/model.h"', True),
    ("records/b.cpp", '#include "libdda/model/ground_motion.h"', False),
    ("records/c.cpp", "#include <nlohmann/json.hpp>", True),
    ("records/d.cpp", "#pragma omp parallel for", True),
    ("records/e.cpp", '  #  include "importers/mesh/read_mesh.h"', True),
    ("app/run.cpp", '#include "records/record.h"', False),
    ("app/run.h", "#include <CLI/CLI.hpp>", True),
    ("app/commands/a.cpp", "#include <yaml-cpp/yaml.h>", True),
    ("app/case/a.cpp", "#include <yaml-cpp/yaml.h>", False),
    ("app/render/a.cpp", "#include <hdf5.h>", True),
    ("app/render/b.cpp", "#include <GL/osmesa.h>", False),
    ("app/results/a.cpp", "#include <hdf5.h>", False),
    ("app/results/b.cpp", "#include <cairo/cairo.h>", True),
    ("app/plots/a.cpp", "#include <cairo.h>", False),
    ("app/plots/a.h", "#include <cairo.h>", True),
    ("app/verify/a.cpp", "#include <cairo.h>", True),
    ("app/verify/b.cpp", "#include <GL/osmesa.h>", True),
    ("app/results/c.cpp", "#include <openssl/md5.h>", True),
    ("app/results/d.cpp", '#include "case_file.h"', True),
    ("app/results/e.cpp", '#include "app/results/a.cpp"', True),
    ("tests/records/a.cpp", "#include <gtest/gtest.h>", False),
    ("tests/records/b.cpp", "#include <hdf5.h>", True),
    ("app/results/f.cpp", "#include <gtest/gtest.h>", True),
    ("app/results/g.cpp", "#include <sys/wait.h>", False),
    ("app/results/h.cpp", "#include <vector>", False),
)
HEADERS = ("libdda/errors.h", "libdda/geometry/moments.h", "libdda/model/model.h", "libdda/model/ground_motion.h",
           "records/record.h", "importers/mesh/read_mesh.h", "app/case/case_file.h")


def self_test():
    wrong = []
    for planted, line, is_fault in PLANTED:
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            for path in HEADERS + (planted,):
                (root / path).parent.mkdir(parents=True, exist_ok=True)
                (root / path).write_text("// clean\n", encoding="utf-8")
            (root / planted).write_text(f"// first line\n{line}\n", encoding="utf-8")
            _, faults = check(root)
            found = len(faults) == 1 and faults[0].startswith(f"{planted}:2:")
            if found != is_fault or (not is_fault and faults):
                wrong.append(f"{planted}: {line}: {'not found' if is_fault else 'wrongly refused'} {faults}")
    return len(PLANTED), wrong


def main(arguments):
    if arguments == ["--self-test"]:
        count, faults = self_test()
        subject = "planted lines judged rightly"
    else:
        root = Path(arguments[0]) if arguments else Path(__file__).resolve().parent.parent
        count, faults = check(root)
        subject = "files include only what they may"
        if count == 0:
            faults = [f"{root}: no C++ files found"]
    for fault in faults:
        print(fault)
    if not faults:
        print(f"{count} {subject}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
