#!/usr/bin/env python3
"""The type stubs name what the modules have, with the same arguments and defaults, and everything has a docstring.

test_stubs.py FOLDER. FOLDER: of the stubs.
"""
import ast
import enum
import importlib
import inspect
import sys
from pathlib import Path

import support


def public(names):
    return {name for name in names if not name.startswith("_")}


def arguments_of(function, what):
    """Names and defaults of a parsed signature, self left out; keyword-only ones after None."""
    arguments = function.args
    assert arguments.vararg is None and arguments.kwarg is None, what
    positional = arguments.posonlyargs + arguments.args
    defaults = [None] * (len(positional) - len(arguments.defaults)) + arguments.defaults
    pairs = list(zip(positional, defaults)) + [(None, None)] + list(zip(arguments.kwonlyargs, arguments.kw_defaults))
    return [(argument and argument.arg, default and ast.dump(default)) for argument, default in pairs
            if argument is None or argument.arg != "self"]


def signature_of(callable_, what):
    """pybind11 writes it to the first line of a docstring; the text comes after an empty line."""
    line, _, text = callable_.__doc__.partition("\n")
    assert text.strip(), f"{what} has no docstring"
    return arguments_of(ast.parse(f"def {line}: ...").body[0], what)


def decorators(node):
    return {ast.unparse(decorator) for decorator in node.decorator_list}


def check_enum(node, cls, what):
    assert issubclass(cls, enum.IntEnum) and "enum.IntEnum" in {ast.unparse(base) for base in node.bases}, what
    members = {line.targets[0].id: ast.literal_eval(line.value) for line in node.body}
    assert members == {member.name: member.value for member in cls}, what
    assert all(name in cls.__doc__ or name == "Nothing" for name in members) or "others" in cls.__doc__, what


def check_class(node, cls, what):
    assert cls.__doc__, f"{what} has no docstring"
    functions = [line for line in node.body if isinstance(line, ast.FunctionDef)]
    assert len(functions) == len([line for line in node.body if not isinstance(line, ast.Expr)]), what
    setters = {function.name for function in functions if f"{function.name}.setter" in decorators(function)}
    getters = [function for function in functions if function.name not in setters or "property" in decorators(function)]
    names = [function.name for function in getters]
    assert len(names) == len(set(names)), f"{what}: a name twice"
    assert public(names) == public(vars(cls)), f"{what}: {public(names) ^ public(vars(cls))}"
    for function in getters:
        name, kinds = f"{what}.{function.name}", decorators(function)
        if function.name == "__init__":
            assert arguments_of(function, name) == signature_of(cls.__init__, name), name
            continue
        attribute = inspect.getattr_static(cls, function.name)
        assert ("property" in kinds) == isinstance(attribute, property), name
        assert ("staticmethod" in kinds) == isinstance(attribute, staticmethod), name
        if isinstance(attribute, property):
            assert attribute.__doc__, f"{name} has no docstring"
            assert (attribute.fset is not None) == (function.name in setters), f"{name}: setter"
        else:
            assert arguments_of(function, name) == signature_of(getattr(cls, function.name), name), name
    if "__init__" not in names:
        support.raises(TypeError, "No constructor defined", cls)


for module_name in ("rme", "synthetic_arm"):
    module = importlib.import_module(module_name)
    assert module.__doc__
    tree = ast.parse((Path(sys.argv[1]) / f"{module_name}.pyi").read_text(encoding="utf-8"))
    beside = Path(module.__file__).with_name(f"{module_name}.pyi")  # where editors look for it
    assert beside.exists(), f"{beside}: expected the type stub beside the module, found none"
    found = set()
    for node in tree.body:
        if isinstance(node, (ast.Import, ast.ImportFrom, ast.Expr)):
            continue
        name = node.target.id if isinstance(node, ast.AnnAssign) else node.name
        what, found = f"{module_name}.{name}", found | {name}
        thing = getattr(module, name)
        if isinstance(node, ast.AnnAssign):
            assert type(thing).__name__ == ast.unparse(node.annotation), what
        elif isinstance(node, ast.FunctionDef):
            assert arguments_of(node, what) == signature_of(thing, what), what
        elif issubclass(thing, enum.Enum):
            check_enum(node, thing, what)
        else:
            check_class(node, thing, what)
    assert public(found) == public(vars(module)), f"{module_name}: {public(found) ^ public(vars(module))}"
print("ok")
