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

# What files of a folder may include from the repository beside their own folder, by the beginning of the path. The
# longest folder that a file lies in decides; every folder with sources stands here. From below: a folder names only
# folders above it in its own block.
ENGINE_MODEL = ("libdda/errors.h", "libdda/geometry/", "libdda/model/")
READS = ("libdda/errors.h", "libdda/text/")  # what takes files apart
# The inside of a step, from its blocks up to advance(): each names only those before it.
STEP = ("libdda/block/", "libdda/forces/", "libdda/problem/", "libdda/iterate/", "libdda/impact/", "libdda/step/")
ENGINE = ("libdda/errors.h", "libdda/geometry/", "libdda/model/", "libdda/contact/", *STEP, "libdda/analysis/",
          "libdda/limit/", "libdda/run/")
FOLDER_RULES = {
    "libdda/": ("libdda/geometry/", "libdda/model/", "libdda/contact/", *STEP, "libdda/analysis/", "libdda/run/"),
    "libdda/text/": ("libdda/errors.h",),
    "libdda/geometry/": ("libdda/errors.h",),
    "libdda/model/": ("libdda/errors.h", "libdda/geometry/"),
    "libdda/contact/": ENGINE_MODEL,
    "libdda/solve/": ENGINE_MODEL,
    "libdda/block/": ENGINE_MODEL,
    "libdda/forces/": ENGINE_MODEL + ("libdda/contact/", "libdda/solve/block_matrix.h", "libdda/block/"),
    # What is to be solved knows no solver: of libdda/solve/ the matrix alone.
    "libdda/problem/": ENGINE_MODEL + ("libdda/contact/", "libdda/solve/block_matrix.h", "libdda/block/", "libdda/forces/"),
    "libdda/iterate/": ENGINE_MODEL + ("libdda/contact/", "libdda/solve/", "libdda/block/", "libdda/forces/", "libdda/problem/"),
    "libdda/impact/": ENGINE_MODEL + ("libdda/contact/", "libdda/block/", "libdda/forces/", "libdda/problem/"),
    "libdda/step/": ENGINE_MODEL + ("libdda/contact/", *STEP),
    "libdda/analysis/": ENGINE_MODEL + ("libdda/contact/", "libdda/solve/", *STEP),
    "libdda/limit/": ENGINE_MODEL + ("libdda/contact/", "libdda/solve/", "libdda/analysis/"),
    "libdda/run/": ENGINE_MODEL + ("libdda/contact/", *STEP, "libdda/analysis/", "libdda/limit/"),

    # importers/process/: how every program begins, for records/generate_main.cpp
    "records/": READS + ("importers/process/", "libdda/model/ground_motion.h", "libdda/model/standard_gravity.h", "records/formats/",
                         "records/measures/", "records/processing/", "records/synthetic/"),
    "records/formats/": READS + ("records/*",),
    "records/measures/": READS + ("records/*",),
    "records/synthetic/": READS + ("records/*", "records/measures/"),
    "records/processing/": READS + ("records/*", "records/measures/", "records/synthetic/"),

    "importers/": ("importers/exact/", "importers/mesh/", "importers/patterns/"),
    "importers/process/": ("libdda/errors.h", "libdda/text/"),
    "importers/mesh/": READS + ("libdda/geometry/",),
    "importers/exact/": ("libdda/errors.h", "libdda/geometry/", "importers/mesh/"),
    "importers/fit/": ("libdda/errors.h", "libdda/geometry/", "importers/mesh/", "importers/exact/"),
    "importers/patterns/": ("libdda/errors.h", "libdda/geometry/", "importers/mesh/"),
    "importers/helper/": ENGINE_MODEL + ("libdda/contact/", "importers/process/", "importers/mesh/", "importers/exact/", "importers/fit/"),
    "importers/assembly/": ENGINE_MODEL + ("libdda/contact/", "importers/mesh/", "importers/helper/"),

    "app/version/": ("libdda/compilation.h",),
    "app/golden/": ENGINE + ("libdda/compilation.h", "importers/process/", "app/version/"),
    "app/words/": ENGINE + ("libdda/text/",),
    "app/case/": ENGINE_MODEL,
    "app/reader/": ENGINE + ("libdda/text/", "importers/", "records/", "app/words/", "app/case/"),
    "app/results/": ENGINE + ("app/version/", "app/words/", "app/case/"),
    "app/problems/": ENGINE + ("libdda/text/", "importers/process/", "app/words/", "app/case/", "app/reader/", "app/results/"),
    "app/drawing/": ("libdda/errors.h", "importers/process/"),
    "app/plots/": ("libdda/errors.h", "importers/process/", "app/words/", "app/drawing/"),
    "app/render/": ENGINE + ("importers/process/", "importers/mesh/", "importers/helper/", "app/words/", "app/case/",
                             "app/results/", "app/drawing/"),
    "app/report/": ENGINE + ("importers/process/", "records/", "app/words/", "app/case/", "app/results/", "app/plots/", "app/render/"),
    "app/generate/": ("libdda/errors.h", "libdda/geometry/", "importers/process/", "importers/mesh/", "importers/patterns/"),
    "app/studies/scenes/": ENGINE,
    "app/studies/verify/": ENGINE + ("app/version/", "importers/patterns/", "app/words/", "app/plots/", "app/studies/scenes/",
                                     "app/studies/verify/references/"),
    "app/studies/verify/references/": (),
    "app/studies/converge/": ENGINE + ("app/version/", "libdda/text/", "app/words/", "app/case/", "app/results/", "app/plots/"),
    "app/studies/ensemble/": ENGINE + ("app/version/", "importers/process/", "app/words/", "app/case/", "app/results/", "app/plots/",
                                       "app/studies/converge/"),
    "app/studies/limit/": ENGINE + ("app/version/", "app/words/", "app/case/"),
    "app/studies/stability/": ENGINE + ("app/version/", "importers/process/", "app/words/", "app/case/", "app/plots/",
                                        "app/studies/scenes/", "app/studies/stability/references/"),
    "app/studies/stability/references/": (),
    "app/command_line/": ("importers/helper/", "app/commands/"),
    "app/commands/": ENGINE + ("libdda/text/", "importers/", "records/", "app/"),
    "app/": ENGINE + ("importers/", "app/"),

    "tests/": ("tests/", "app/", "importers/", "records/", "libdda/"),
    "tests/libdda/": ("tests/", "libdda/"),
    "tests/records/": ("tests/", "libdda/", "records/"),
    "tests/importers/": ("tests/", "libdda/", "importers/"),
}

# Foreign libraries: how their includes look, the folders that may include them, and whether headers may.
# A test may use the library of the module it tests.
FOREIGN_RULES = (
    ("Eigen", r"(unsupported/)?Eigen/", ("libdda/", "importers/", "records/", "app/", "tests/"), True),
    ("Google Benchmark", r"benchmark/", ("tests/bench/",), False),
    ("Bullet", r"(BulletDynamics/|btBulletDynamicsCommon\.h$)", ("tests/peers/run_bullet.cpp",), False),
    ("ODE", r"ode/", ("tests/peers/run_ode.cpp",), False),
    ("GoogleTest", r"g(test|mock)/", ("tests/",), True),
    ("SuiteSparse", r"(suitesparse/|cholmod|umfpack|amd|camd|colamd|ccolamd|SuiteSparse)", ("libdda/solve/",), False),
    ("OpenMP", r"omp\.h$", (), False),
    ("assimp", r"assimp/", ("importers/mesh/",), False),
    ("CGAL", r"(CGAL/|boost/|gmp|mpfr)", ("importers/exact/",), False),
    ("yaml-cpp", r"yaml-cpp/", ("app/reader/",), False),
    ("HDF5", r"(hdf5|H5)", ("app/results/",), False),
    ("Cairo", r"cairo", ("app/drawing/", "app/render/", "app/plots/"), False),
    ("OSMesa, OpenGL, PNG", r"(GL/|EGL/|png\.h|ft2build|freetype)", ("app/render/",), False),
    ("pugixml", r"pugixml\.hpp$", ("importers/mesh/", "records/formats/"), False),
    ("libzip", r"zip\.h$", ("importers/mesh/",), False),
    ("zlib", r"zlib\.h$", ("records/", "tests/"), False),
    ("libmseed", r"libmseed\.h$", ("records/formats/",), False),
    ("CLP", r"(Clp|Coin)", ("libdda/limit/",), False),
    ("FFTW", r"fftw3\.h$", ("records/",), False),
    ("nlohmann-json", r"nlohmann/", ("app/", "importers/mesh/", "importers/helper/", "tests/"), False),
    ("fmt", r"fmt/", ("app/", "importers/assembly/"), False),
    ("utf8cpp", r"utf8(\.h$|/)", ("libdda/text/",), False),
    ("CLI11", r"CLI/", ("app/", "records/generate_main.cpp"), False),
    ("voussoir as installed", r"voussoir/", ("tests/package/libraries/",), False),
)
TESTS_OF = {"libdda/solve/": ("tests/libdda/solve/",), "libdda/": ("tests/libdda/",),
            "importers/mesh/": ("tests/importers/mesh/", "tests/importers/helper/"),
            "importers/exact/": ("tests/importers/exact/",), "app/reader/": ("tests/app/reader/",),
            "app/results/": ("tests/app/results/",), "app/drawing/": ("tests/app/render/",),
            "app/render/": ("tests/app/render/",), "app/": ("tests/app/", "tests/verification/")}

# The system's own headers beside those of the C++ standard (which have no slash and no ".h").
POSIX = re.compile(r"(sys/.*|unistd|fcntl|spawn|execinfo|link|poll|signal|pthread|dlfcn|fenv|ftw|sched|termios|time|gnu/libc-version)\.h$")

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
    folder = folder_of(path)
    if folder is None:
        return f"{path.rsplit('/', 1)[0]}/ has no rule; add one to FOLDER_RULES of scripts/check_includes.py"
    # Another module's .cpp is nobody's to include.
    if not included.endswith(".h"):
        return f'"{included}": only headers are included'
    if may_include(folder, included):
        return None
    return f'"{included}": {folder} may include only {", ".join((folder,) + FOLDER_RULES[folder])}'


def folder_of(path):
    """The longest folder of FOLDER_RULES that holds a file, if that is its own or a folder of tests."""
    holding = [folder for folder in FOLDER_RULES if path.startswith(folder)]
    longest = max(holding, key=len, default=None)
    own = path.rsplit("/", 1)[0] + "/"
    return longest if longest == own or path.startswith("tests/") else None


def may_include(folder, included):
    if included.startswith(folder) and (folder.startswith("tests/") or "/" not in included[len(folder):]):
        return True
    for allowed in FOLDER_RULES[folder]:
        if allowed.endswith("/*"):  # the files of the folder, not those of its own folders
            if included.startswith(allowed[:-1]) and "/" not in included[len(allowed) - 1:]:
                return True
        elif included.startswith(allowed):
            return True
    return False


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
        elif OPENMP_PRAGMA.match(line):
            fault = "OpenMP's threads spin when they have nothing to do: use libdda/model/parallel.h"
        if fault:
            faults.append(f"{path}:{number}: {fault}")
    return faults


def check(root):
    files = sorted(file.relative_to(root).as_posix() for module in MODULES if (root / module).is_dir()
                   for file in (root / module).rglob("*") if file.suffix in (".h", ".cpp"))
    return len(files), [fault for path in files for fault in faults_of_file(root, path)]


# path, line, and whether the line is a fault
PLANTED = (
    ("libdda/step/a.cpp", '#include "app/reader/case_file.h"', True),
    ("libdda/step/b.cpp", '#include "libdda/errors.h"', False),
    ("libdda/step/c.cpp", "#include <cholmod.h>", True),
    ("libdda/solve/d.cpp", "#include <cholmod.h>", False),
    ("libdda/solve/d.h", "#include <suitesparse/cholmod.h>", True),
    ("libdda/solve/e.cpp", "#include <fmt/core.h>", True),
    ("libdda/solve/f.cpp", "#pragma omp parallel for", True),
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
    ("tests/importers/a.cpp", '#include "app/reader/case_file.h"', True),
    ("tests/importers/b.cpp", '#include "importers/mesh/read_mesh.h"', False),
    ("app/nowhere/a.cpp", '#include "libdda/errors.h"', True),
    ("records/c.cpp", "#include <nlohmann/json.hpp>", True),
    ("records/d.cpp", "#pragma omp parallel for", True),
    ("records/generate_main.cpp", "#include <CLI/CLI.hpp>", False),
    ("records/h.cpp", "#include <CLI/CLI.hpp>", True),
    ("records/generate_main.cpp", "#include <getopt.h>", True),
    ("records/e.cpp", '  #  include "importers/mesh/read_mesh.h"', True),
    ("app/commands/run.cpp", '#include "records/record.h"', False),
    ("app/run.h", "#include <CLI/CLI.hpp>", True),
    ("app/commands/a.cpp", "#include <yaml-cpp/yaml.h>", True),
    ("app/reader/a.cpp", "#include <yaml-cpp/yaml.h>", False),
    ("app/render/a.cpp", "#include <hdf5.h>", True),
    ("app/render/b.cpp", "#include <GL/osmesa.h>", False),
    ("app/results/a.cpp", "#include <hdf5.h>", False),
    ("app/results/b.cpp", "#include <cairo/cairo.h>", True),
    ("app/plots/a.cpp", "#include <cairo.h>", False),
    ("app/plots/a.h", "#include <cairo.h>", True),
    ("app/studies/verify/a.cpp", "#include <cairo.h>", True),
    ("app/studies/verify/b.cpp", "#include <GL/osmesa.h>", True),
    ("app/results/c.cpp", "#include <openssl/md5.h>", True),
    ("app/results/d.cpp", '#include "case_file.h"', True),
    ("app/results/e.cpp", '#include "app/results/a.cpp"', True),
    ("tests/records/a.cpp", "#include <gtest/gtest.h>", False),
    ("tests/records/b.cpp", "#include <hdf5.h>", True),
    ("app/results/f.cpp", "#include <gtest/gtest.h>", True),
    ("app/results/g.cpp", "#include <sys/wait.h>", False),
    ("app/results/h.cpp", "#include <vector>", False),
)
# Folders from below: none may include what stands behind it in its row.
ROWS = (
    ("libdda/geometry/", "libdda/model/", "libdda/contact/", *STEP, "libdda/analysis/", "libdda/limit/", "libdda/run/"),
    ("libdda/model/", "libdda/solve/", "libdda/iterate/"),
    ("libdda/text/", "libdda/geometry/"),
    ("records/measures/", "records/synthetic/", "records/processing/"),
    ("importers/process/", "importers/mesh/", "importers/exact/", "importers/helper/", "importers/assembly/"),
    ("app/words/", "app/case/", "app/results/", "app/drawing/", "app/plots/", "app/render/", "app/generate/",
     "app/studies/scenes/", "app/studies/verify/", "app/studies/converge/", "app/studies/ensemble/",
     "app/studies/limit/", "app/studies/stability/", "app/commands/"),
    ("app/words/", "app/case/", "app/reader/", "app/commands/"),
    ("app/words/", "app/case/", "app/reader/", "app/problems/"), ("app/results/", "app/problems/"),
    # The reader of case files is the commands' alone.
    ("app/results/", "app/reader/"), ("app/render/", "app/reader/"), ("app/plots/", "app/reader/"),
    ("app/studies/verify/", "app/reader/"), ("app/studies/converge/", "app/reader/"),
    ("app/studies/ensemble/", "app/reader/"), ("app/studies/limit/", "app/reader/"),
    ("app/studies/stability/", "app/reader/"),
)
HEADERS = ("libdda/errors.h", "libdda/geometry/moments.h", "libdda/model/model.h", "libdda/model/ground_motion.h",
           "records/record.h", "importers/mesh/read_mesh.h", "app/reader/case_file.h")


def verdict(planted, line, headers):
    """What `check` finds in a file of one comment and this line, in a tree with these headers."""
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder)
        for path in headers + (planted,):
            (root / path).parent.mkdir(parents=True, exist_ok=True)
            (root / path).write_text("// clean\n", encoding="utf-8")
        (root / planted).write_text(f"// first line\n{line}\n", encoding="utf-8")
        return check(root)[1]


def self_test():
    wrong = []
    for planted, line, is_fault in PLANTED:
        faults = verdict(planted, line, HEADERS)
        found = len(faults) == 1 and faults[0].startswith(f"{planted}:2:")
        if found != is_fault or (not is_fault and faults):
            wrong.append(f"{planted}: {line}: {'not found' if is_fault else 'wrongly refused'} {faults}")
    upward = [(lower, higher) for row in ROWS for i, lower in enumerate(row) for higher in row[i + 1:]]
    for lower, higher in upward:
        if len(verdict(lower + "a.cpp", f'#include "{higher}b.h"', (higher + "b.h",))) != 1:
            wrong.append(f"{lower} may include {higher}, which stands above it")
    return len(PLANTED) + len(upward), wrong


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
