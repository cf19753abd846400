"""The committed type stub says what the module has, and nothing else."""

import ast
from pathlib import Path

import eyecore

STUB = ast.parse((Path(__file__).parents[2] / "bindings" / "eyecore.pyi").read_text())


def declared(body: list[ast.stmt]) -> set[str]:
    names = set()
    for node in body:
        if isinstance(node, ast.FunctionDef | ast.ClassDef):
            names.add(node.name)
        elif isinstance(node, ast.AnnAssign) and isinstance(node.target, ast.Name):
            names.add(node.target.id)
    return names


def public(thing: object) -> set[str]:
    return {name for name in vars(thing) if not name.startswith("_")}


def test_module_and_stub_have_the_same_names() -> None:
    assert declared(STUB.body) - {"__version__"} == public(eyecore)


def test_classes_and_stub_have_the_same_members() -> None:
    for node in STUB.body:
        if isinstance(node, ast.ClassDef):
            expected = {name for name in declared(node.body) if not name.startswith("__")}
            assert expected == public(getattr(eyecore, node.name)), node.name


def options(thing: type) -> set[str]:
    return {name for name, item in vars(thing).items() if getattr(item, "fset", None)}


def test_constructors_take_the_options_that_can_be_set() -> None:
    described_by = {"Eye": eyecore.EyeDescription}
    for node in STUB.body:
        if (
            isinstance(node, ast.ClassDef)
            and "**kwargs" in getattr(eyecore, node.name).__init__.__doc__
        ):
            (made,) = (m for m in node.body if getattr(m, "name", "") == "__init__")
            taken = {argument.arg for argument in made.args.kwonlyargs}
            assert taken == options(described_by.get(node.name, getattr(eyecore, node.name)))


def test_stub_and_docstrings_name_the_same_arguments() -> None:
    """pybind11 writes a signature into each docstring."""
    for node in STUB.body:
        if not isinstance(node, ast.ClassDef):
            continue
        for method in (m for m in node.body if isinstance(m, ast.FunctionDef)):
            if any(isinstance(d, ast.Name) and d.id == "property" for d in method.decorator_list):
                continue
            documented = getattr(getattr(eyecore, node.name), method.name).__doc__
            if "**kwargs" in documented:
                continue
            for argument in (*method.args.args, *method.args.kwonlyargs):
                if argument.arg != "self":
                    assert argument.arg in documented, f"{node.name}.{method.name}"
