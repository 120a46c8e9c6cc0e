"""Makes the wheel for `pip install .` (PEP 517), by CMake, in build-python/,
where an interrupted build goes on. A build that there is already is taken with
`--config-settings build=build`."""

import base64
import hashlib
import importlib.util
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZipFile

if sys.version_info < (3, 11):
    sys.exit("libcontact needs Python 3.11 or later")
import tomllib

PROJECT = tomllib.loads(Path("pyproject.toml").read_text())["project"]
VERSION = re.search(
    r"project\([^)]*VERSION ([\d.]+)", Path("CMakeLists.txt").read_text()
)[1]
NAME = f"{PROJECT['name']}-{VERSION}"
PYTHON = "cp{}{}".format(*sys.version_info)
TAG = f"{PYTHON}-{PYTHON}-{re.sub(r'[^0-9a-z]', '_', sysconfig.get_platform())}"


def prepare_metadata_for_build_wheel(folder, config_settings=None):
    info = Path(folder) / f"{NAME}.dist-info"
    write_info(info)
    return info.name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    build = Path((config_settings or {}).get("build", "build-python"))
    check_needs(build)
    wheel = f"{NAME}-{TAG}.whl"
    with tempfile.TemporaryDirectory() as work:
        package = Path(work)
        build_package(build, package)
        write_info(package / f"{NAME}.dist-info")
        record = f"{NAME}.dist-info/RECORD"
        lines = []
        with ZipFile(Path(wheel_directory) / wheel, "w", ZIP_DEFLATED) as archive:
            for file in sorted(f for f in package.rglob("*") if f.is_file()):
                name = file.relative_to(package).as_posix()
                content = file.read_bytes()
                digest = hashlib.sha256(content).digest()
                code = base64.urlsafe_b64encode(digest).rstrip(b"=").decode()
                lines.append(f"{name},sha256={code},{len(content)}\n")
                archive.write(file, name)
            archive.writestr(record, "".join(lines) + f"{record},,\n")
    return wheel


def build_editable(*_):
    sys.exit(
        "libcontact cannot be installed with -e: put build/python of its build "
        "on PYTHONPATH, whose Python files are those of the source tree"
    )


def write_info(info):
    """The metadata, which need no build."""
    info.mkdir()
    fields = {
        "Metadata-Version": "2.1",
        "Name": PROJECT["name"],
        "Version": VERSION,
        "Summary": PROJECT["description"],
        "License": PROJECT["license"]["text"],
        "License-File": "LICENSE",
        "Requires-Python": PROJECT["requires-python"],
        "Description-Content-Type": "text/markdown",
    }
    lines = [f"{field}: {value}\n" for field, value in fields.items()]
    lines += [f"Requires-Dist: {d}\n" for d in PROJECT["dependencies"]]
    readme = Path(PROJECT["readme"]).read_text()
    (info / "METADATA").write_text("".join(lines) + "\n" + readme)
    (info / "WHEEL").write_text(
        "Wheel-Version: 1.0\nGenerator: build_backend\n"
        f"Root-Is-Purelib: false\nTag: {TAG}\n"
    )
    shutil.copy("LICENSE", info)


def check_needs(build):
    """Says in a sentence what is missing, before CMake does in many."""
    missing = [p for p in ("cmake", "ninja") if not shutil.which(p)]
    if missing:
        sys.exit(
            f"libcontact is built by {' and '.join(missing)}, which cannot be "
            "found; scripts/setup.sh installs what the build needs"
        )
    if not importlib.util.find_spec("numpy"):
        sys.exit(
            f"libcontact is built with the NumPy of {sys.executable}, which has "
            "none: make the environment with --system-site-packages and give pip "
            "--no-build-isolation"
        )
    if build.name != "build-python" and not (build / "CMakeCache.txt").exists():
        sys.exit(f"build={build} is no build of libcontact")
    cache = build / "CMakeCache.txt"
    if cache.exists():
        other = re.search(r"^Python_EXECUTABLE:\w+=(.*)$", cache.read_text(), re.M)
        version = other and subprocess.run(
            [other[1], "-c", "import sys; print('cp%d%d' % sys.version_info[:2])"],
            capture_output=True, text=True,
        ).stdout.strip()  # fmt: skip
        if version != PYTHON:
            sys.exit(
                f"build={build} is for {version or 'no Python'}, this is {PYTHON}; "
                "leave build= out, or configure it with -D Python_EXECUTABLE="
                f"{sys.executable}"
            )


def build_package(build, package):
    """Builds the module and the programs, and copies what belongs to them."""
    def cmake(*arguments):
        if subprocess.run(["cmake", *arguments]).returncode:
            sys.exit(
                "libcontact could not be built, for the reason above; "
                "scripts/setup.sh installs what the build needs"
            )

    print(f"libcontact is built in {build}; this takes some minutes", flush=True)
    if not (build / "CMakeCache.txt").exists():
        cmake(
            "-B", build, "-G", "Ninja", "-D", "CMAKE_BUILD_TYPE=Release",
            "-D", f"Python_EXECUTABLE={sys.executable}",
            "-D", "CONTACT_BUILD_TESTS=OFF", "-D", "CONTACT_BUILD_BENCH=OFF",
        )  # fmt: skip
    cmake("--build", build, "--target", "contact_python", "programs")
    installed = package / "installed"
    for component in "python", "programs":
        cmake(
            "--install", build, "--component", component,
            "--prefix", installed, "--strip",
        )  # fmt: skip
    (package / f"{NAME}.data").mkdir()
    (installed / "bin").rename(package / f"{NAME}.data" / "scripts")
    libraries = package / f"{NAME}.data" / "data" / "lib"
    libraries.mkdir(parents=True)
    for library in installed.glob("lib/**/libcontact_fmu_*.so"):  # for hinge-fmu
        library.rename(libraries / library.name)
    python = installed / "lib" / "python3" / "dist-packages"
    (python / "libcontact").rename(package / "libcontact")
    shutil.rmtree(installed)
