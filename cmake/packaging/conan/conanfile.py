import os
import re

from conan import ConanFile
from conan.tools.cmake import CMake, CMakeDeps, CMakeToolchain
from conan.tools.files import copy, load

required_conan_version = ">=2.0"


class RmeConan(ConanFile):
    """Packages the checkout that this recipe lies in, by way of its own install rules."""

    name = "rme"
    description = "Payload mass and centre of mass of a torque-controlled arm within milliseconds, and a passive controller."
    license = "MIT"
    topics = ("robotics", "control", "estimation", "header-only")
    package_type = "header-library"
    settings = "os", "arch", "compiler", "build_type"
    options = {"with_json": [True, False]}
    default_options = {"with_json": True}

    @property
    def _root(self):
        return os.path.join(self.recipe_folder, "..", "..", "..")

    def set_version(self):
        project = load(self, os.path.join(self._root, "CMakeLists.txt"))
        self.version = re.search(r"project\(rme VERSION ([0-9.]+)", project).group(1)

    def export_sources(self):
        for pattern in ("CMakeLists.txt", "LICENSE", "cmake/*.cmake", "cmake/*.cmake.in", "include/*.hpp"):
            copy(self, pattern, src=self._root, dst=self.export_sources_folder)

    def requirements(self):
        self.requires("eigen/[>=3.3 <4]")
        if self.options.with_json:
            self.requires("nlohmann_json/[>=3.7 <4]")

    def generate(self):
        toolchain = CMakeToolchain(self)
        toolchain.cache_variables["RME_INSTALL"] = True
        toolchain.cache_variables["RME_WITH_JSON"] = bool(self.options.with_json)
        toolchain.cache_variables["RME_BUILD_TESTS"] = False
        toolchain.cache_variables["RME_BUILD_EXAMPLES"] = False
        toolchain.generate()
        CMakeDeps(self).generate()

    def build(self):
        CMake(self).configure()

    def package(self):
        CMake(self).install()
        copy(self, "LICENSE", src=self.source_folder, dst=os.path.join(self.package_folder, "licenses"))

    def package_id(self):
        self.info.settings.clear()

    def package_info(self):
        # The package brings its own CMake files; Conan makes none.
        self.cpp_info.set_property("cmake_find_mode", "none")
        self.cpp_info.builddirs = [os.path.join("lib", "cmake", "rme")]
        self.cpp_info.bindirs = []
        self.cpp_info.libdirs = []
