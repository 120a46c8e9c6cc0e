"""Recipe for Conan 2 of the library and its C interface, without programs. Not
run yet: conan create . -s compiler.cppstd=20 --build=missing"""

import re
from pathlib import Path

from conan import ConanFile
from conan.tools.build import check_min_cppstd
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain, cmake_layout
from conan.tools.files import copy


class Libcontact(ConanFile):
    name = "libcontact"
    description = "Contact size, friction force and friction moments of hinges"
    license = "MIT"
    package_type = "static-library"  # and the C interface as a shared one
    settings = "os", "arch", "compiler", "build_type"
    exports_sources = (
        "README.md", "CHANGELOG.md", "CONTRIBUTING.md", "LICENSE",
        "CMakeLists.txt", "cmake/*", "libcontact/*", "data/*", "plots/*")  # fmt: skip
    # Headers alone are taken of them.
    default_options = {"boost/*:header_only": True, "fmt/*:header_only": True}

    def set_version(self):
        text = Path(self.recipe_folder, "CMakeLists.txt").read_text()
        self.version = re.search(r"project\([^)]*VERSION ([\d.]+)", text)[1]

    def requirements(self):
        self.requires("eigen/3.4.0", transitive_headers=True)
        self.requires("boost/[>=1.74]")
        self.requires("fmt/[>=9]")
        self.requires("tomlplusplus/[>=3.3]")

    def validate(self):
        check_min_cppstd(self, 20)

    def layout(self):
        cmake_layout(self)

    def generate(self):
        toolchain = CMakeToolchain(self)
        for part in "APPS", "PYTHON", "TESTS", "BENCH", "REFERENCE":
            toolchain.variables[f"CONTACT_BUILD_{part}"] = False
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        cmake = CMake(self)
        cmake.configure()
        cmake.build()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", self.source_folder, str(Path(self.package_folder, "licenses")))

    def package_info(self):  # contactConfig.cmake is installed
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = ["lib/cmake/contact", "lib/cmake/libcontact"]
