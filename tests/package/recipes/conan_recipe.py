#!/usr/bin/env python3
"""conan_recipe.py SOURCE STAGE CXX EIGEN3_DIR: runs the Conan recipe with stand-ins for Conan's functions.

Exports the sources that the recipe names, configures and installs these, and builds and runs its test package.
"""
import ast
import fnmatch
import os
import shutil
import subprocess
import sys
import types
from pathlib import Path

source, stage = Path(sys.argv[1]), Path(sys.argv[2])
compiler, eigen = sys.argv[3:5]
shutil.rmtree(stage, ignore_errors=True)
recipes = source / "cmake" / "packaging" / "conan"


def cmake(*arguments):
    subprocess.run(["cmake", *map(str, arguments)], check=True, stdout=subprocess.DEVNULL)


def copy(_, pattern, src, dst):
    """As Conan's: every file whose path from src matches, under the same path.

    Other tests make and delete folders under src meanwhile: os.walk passes over those that are gone, rglob does not.
    """
    src = Path(src).resolve()
    for folder, _, names in os.walk(src):
        for name in names:
            relative = (Path(folder) / name).relative_to(src)
            if fnmatch.fnmatch(relative.as_posix(), pattern):
                target = Path(dst) / relative
                target.parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(src / relative, target)


class Toolchain:
    def __init__(self, recipe):
        self.cache_variables = {}
        recipe.toolchain = self

    def generate(self):
        pass


class CMake:
    def __init__(self, recipe):
        self.recipe = recipe

    def configure(self):
        options = (f"-D{name}={'ON' if value else 'OFF'}" for name, value in self.recipe.toolchain.cache_variables.items())
        cmake("-S", self.recipe.source_folder, "-B", stage / "build", f"-DCMAKE_CXX_COMPILER={compiler}",
              "-DCMAKE_INSTALL_LIBDIR=lib", *options)

    def install(self):
        cmake("--install", stage / "build", "--prefix", self.recipe.package_folder)


def stand_in(name, **members):
    sys.modules[name] = types.ModuleType(name)
    vars(sys.modules[name]).update(members)


stand_in("conan", ConanFile=object)
stand_in("conan.tools")
stand_in("conan.tools.cmake", CMake=CMake, CMakeToolchain=Toolchain,
         CMakeDeps=lambda recipe: types.SimpleNamespace(generate=lambda: None))
stand_in("conan.tools.files", copy=copy, load=lambda _, path: Path(path).read_text())

scope = {}
exec(compile((recipes / "conanfile.py").read_text(), "conanfile.py", "exec"), scope)
ast.parse((recipes / "test_package" / "conanfile.py").read_text())
recipe = scope["RmeConan"]()
recipe.recipe_folder = str(recipes)
recipe.export_sources_folder = recipe.source_folder = str(stage / "sources")
recipe.package_folder = str(stage / "package")
recipe.options = types.SimpleNamespace(with_json=True)
recipe.cpp_info = types.SimpleNamespace(set_property=lambda *_: None)
required = []
recipe.requires = required.append

recipe.set_version()
recipe.export_sources()
recipe.requirements()
recipe.generate()
recipe.build()
recipe.package()
recipe.package_info()

assert f"project(rme VERSION {recipe.version}" in (source / "CMakeLists.txt").read_text()
assert [name.split("/")[0] for name in required] == ["eigen", "nlohmann_json"], required
package = Path(recipe.package_folder)
wanted = {path.relative_to(source) for path in (source / "include").rglob("*.hpp")}
wanted |= {Path("licenses/LICENSE")}
installed = {path.relative_to(package) for path in package.rglob("*") if path.is_file()}
assert wanted <= installed, f"not installed: {sorted(map(str, wanted - installed))}"
folder = package / recipe.cpp_info.builddirs[0]
assert (folder / "rmeConfig.cmake").exists(), folder

cmake("-S", recipes / "test_package", "-B", stage / "consumer", f"-DCMAKE_CXX_COMPILER={compiler}",
      f"-DCMAKE_PREFIX_PATH={package}", f"-DEigen3_DIR={eigen}")
cmake("--build", stage / "consumer")
subprocess.run([os.fspath(stage / "consumer" / "consumer")], check=True)
print(f"rme {recipe.version}: {len(installed)} files")
