"""Makes the wheel for `pip install .` (PEP 517), by CMake. An existing build is
taken with `--config-settings build=build`."""

import re
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
from pathlib import Path
from zipfile import ZIP_DEFLATED, ZipFile


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    project = tomllib.loads(Path("pyproject.toml").read_text())["project"]
    cmake_lists = Path("CMakeLists.txt").read_text()
    version = re.search(r"project\([^)]*VERSION ([\d.]+)", cmake_lists)
    name = f"{project['name']}-{version[1]}"
    platform = re.sub(r"\W", "_", sysconfig.get_platform())
    python = "cp{}{}".format(*sys.version_info)
    tag = f"{python}-{python}-{platform}"
    wheel = f"{name}-{tag}.whl"
    with (
        tempfile.TemporaryDirectory() as work,
        ZipFile(Path(wheel_directory) / wheel, "w", ZIP_DEFLATED) as archive,
    ):
        package = Path(work) / "package"
        build_package((config_settings or {}).get("build", work), package)
        info = package / f"{name}.dist-info"
        info.mkdir()
        (info / "METADATA").write_text(
            f"Metadata-Version: 2.1\nName: {project['name']}\n"
            f"Version: {version[1]}\nSummary: {project['description']}\n"
            f"Requires-Python: {project['requires-python']}\n"
            + "".join(f"Requires-Dist: {d}\n" for d in project["dependencies"])
        )
        (info / "WHEEL").write_text(
            "Wheel-Version: 1.0\nGenerator: build_backend\n"
            f"Root-Is-Purelib: false\nTag: {tag}\n"
        )
        files = [f for f in sorted(package.rglob("*")) if f.is_file()]
        names = [str(f.relative_to(package)) for f in files]
        record = f"{name}.dist-info/RECORD"
        for file, inside in zip(files, names):
            archive.write(file, inside)
        archive.writestr(record, "".join(f"{n},,\n" for n in names + [record]))
    return wheel


def build_package(build, package):
    """Builds the module and copies the package."""
    cmake = lambda *arguments: subprocess.run(["cmake", *arguments], check=True)
    if not (Path(build) / "CMakeCache.txt").exists():
        cmake(
            "-B", build, "-G", "Ninja", "-D", "CMAKE_BUILD_TYPE=Release",
            "-D", f"Python_EXECUTABLE={sys.executable}",
            "-D", "CONTACT_BUILD_TESTS=OFF", "-D", "CONTACT_BUILD_BENCH=OFF",
            "-D", "CONTACT_BUILD_REFERENCE=OFF",
        )  # fmt: skip
    cmake("--build", build, "--target", "contact_python")
    cmake(
        "--install", build, "--component", "python", "--prefix", package,
        "--strip",
    )  # fmt: skip
