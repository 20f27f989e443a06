"""The ground keeps its promises: documented commands exist, no machine is named, every public function is explained."""

from __future__ import annotations

import ast
import re
import shlex
import subprocess
import tokenize
import tomllib
from importlib.util import find_spec
from pathlib import Path

import click
import pytest
import yaml

import symcheck
from symcheck.cli import cli
from symcheck.papers import load

ROOT = Path(__file__).resolve().parent.parent
MODULES = sorted((ROOT / "symcheck").rglob("*.py"))
GROUND = ("pyproject.toml", "constraints.txt", "Makefile", ".ci/run", "README.md", ".gitignore", "CITATION.cff")
TEXT = {".py", ".md", ".toml", ".txt", ".lark", ".json", ""}
SHELL = r"^```(?:sh|console)\n(.*?)^```"
TARGETS = (
    "audit",
    "test",
    "test-full",
    "test-newest",
    "bench",
    "bench-gpu",
    "browser",
    "docs",
    "notebooks",
    "selftest",
    "coq",
    "coq-check",
    "install-coq",
    "clean",
)


def tracked() -> list[Path]:
    """The text files that git does not ignore."""
    command = ["git", "ls-files", "--cached", "--others", "--exclude-standard"]
    listed = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False).stdout.splitlines()
    return [ROOT / name for name in listed if (ROOT / name).is_file() and Path(name).suffix in TEXT]


def documented_commands() -> list[str]:
    """Each line of the shell blocks of the README and of the guide."""
    files = [ROOT / "README.md", *sorted((ROOT / "notebooks" / "sources" / "guide").glob("*.md"))]
    texts = [file.read_text(encoding="utf-8") for file in files]
    blocks = [block for text in texts for block in re.findall(SHELL, text, flags=re.DOTALL | re.MULTILINE)]
    return [line for block in blocks for line in block.splitlines() if line.strip()]


def make_targets() -> set[str]:
    return set(re.findall(r"^([a-z][a-z-]*):", (ROOT / "Makefile").read_text(encoding="utf-8"), flags=re.MULTILINE))


def test_the_two_commands_are_documented() -> None:
    assert {"make audit", "make test"} <= {line.split("#")[0].strip() for line in documented_commands()}


@pytest.mark.parametrize("line", documented_commands())
def test_each_documented_command_exists(line: str) -> None:
    words = shlex.split(line, comments=True)
    match words:
        case ["make", *targets]:
            assert set(targets) <= make_targets()
        case ["symcheck" | ".venv/bin/symcheck", *arguments]:
            _parse(arguments)
        case ["python" | ".venv/bin/python", "-m", module, *_]:
            assert find_spec(module)
        case ["git" | "cd" | "pip" | "eval", *_]:
            pass
        case _:
            pytest.fail(f"what is {line!r}?")


def _parse(arguments: list[str]) -> None:
    """Parse a command line without running it."""
    if arguments[0].startswith("-"):
        assert arguments[0] in ("--help", "-h", "--version")
        return
    command = cli.commands[arguments[0]]
    command.make_context(arguments[0], arguments[1:], parent=click.Context(cli, **cli.context_settings))


@pytest.mark.parametrize("target", TARGETS)
def test_make_has_the_target(target: str) -> None:
    result = subprocess.run(["make", "-n", target], cwd=ROOT, capture_output=True, text=True, check=False)
    assert result.returncode == 0, result.stderr
    assert target in make_targets()


def test_the_ci_script_is_executable_and_runs_the_tests() -> None:
    script = ROOT / ".ci" / "run"
    assert script.stat().st_mode & 0o111
    assert subprocess.run(["bash", "-n", str(script)], check=False).returncode == 0
    assert "make test" in script.read_text(encoding="utf-8")


def test_no_file_names_a_place_on_some_machine() -> None:
    places = re.compile(r"(?<![\w.])/(?:home|root|work|opt|Users|tmp)/|[A-Z]:\\[A-Za-z]+\\")
    lines = [(file, line) for file in tracked() for line in file.read_text(encoding="utf-8").splitlines()]
    assert [(file.name, line) for file, line in lines if places.search(line)] == []


@pytest.mark.parametrize("name", GROUND)
def test_the_ground_names_no_address(name: str) -> None:
    text = (ROOT / name).read_text(encoding="utf-8")
    assert "://" not in text
    assert "index-url" not in text
    assert "find-links" not in text


@pytest.mark.parametrize("file", MODULES, ids=lambda file: str(file.relative_to(ROOT)))
def test_every_public_function_is_explained(file: Path) -> None:
    tree = ast.parse(file.read_text(encoding="utf-8"))
    functions = [node for node in tree.body if isinstance(node, ast.FunctionDef) and not node.name.startswith("_")]
    assert [function.name for function in functions if not ast.get_docstring(function)] == []
    assert ast.get_docstring(tree) or not tree.body


def without_reason(file: Path) -> list[str]:
    """The numbers and patterns of a module that no comment stands beside or above."""
    with file.open("rb") as source:
        comments = [token for token in tokenize.tokenize(source.readline) if token.type == tokenize.COMMENT]
    beside = {token.start[0] for token in comments}
    above = {token.start[0] for token in comments if token.line.lstrip().startswith("#")}
    constants = [n for n in ast.parse(file.read_text(encoding="utf-8")).body if isinstance(n, ast.Assign)]
    return [
        ast.unparse(constant)
        for constant in constants
        if (_is_number(constant.value) and all(ast.unparse(t).isupper() for t in constant.targets))
        or _is_pattern(constant.value)
        if constant.lineno - 1 not in above and beside.isdisjoint(range(constant.lineno, constant.end_lineno + 1))
    ]


def _is_number(value: ast.expr) -> bool:
    parts = [n for n in ast.walk(value) if isinstance(n, ast.expr)]
    return all(isinstance(n, ast.BinOp | ast.UnaryOp | ast.Tuple) or _is_bare_number(n) for n in parts)


def _is_bare_number(value: ast.expr) -> bool:
    return isinstance(value, ast.Constant) and type(value.value) in (int, float)


def _is_pattern(value: ast.expr) -> bool:
    return isinstance(value, ast.Call) and ast.unparse(value.func) == "re.compile"


def test_every_limit_and_every_search_pattern_has_its_reason() -> None:
    assert {file: bare for file in MODULES if (bare := without_reason(file))} == {}


def test_a_limit_without_a_reason_is_noticed(tmp_path: Path) -> None:
    file = tmp_path / "limits.py"
    file.write_text(
        "A = 1  # a reason\nB = 2, -(1 << 3)\nWORD = 'a'\n# a reason\n_C = re.compile('c')\n_D = re.compile('d')\n"
    )
    assert without_reason(file) == ["B = (2, -(1 << 3))", "_D = re.compile('d')"]


@pytest.mark.parametrize("file", MODULES, ids=lambda file: str(file.relative_to(ROOT)))
def test_no_module_imports_everything_from_another(file: Path) -> None:
    tree = ast.parse(file.read_text(encoding="utf-8"))
    stars = [n for n in ast.walk(tree) if isinstance(n, ast.ImportFrom) and any(a.name == "*" for a in n.names)]
    assert stars == []


def test_the_contract_between_papers_names_all_papers() -> None:
    contracts = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["tool"]["importlinter"][
        "contracts"
    ]
    [listed] = [contract["modules"] for contract in contracts if contract["type"] == "independence"]
    assert listed == [f"symcheck.papers.{key}" for key in load()]


def test_no_module_is_a_drawer_for_everything() -> None:
    assert {"utils.py", "helpers.py", "misc.py", "common.py"} & {file.name for file in MODULES} == set()


def test_what_to_cite_is_this_version() -> None:
    cited = yaml.safe_load((ROOT / "CITATION.cff").read_text(encoding="utf-8"))
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]
    assert (cited["cff-version"], cited["title"], cited["license"]) == ("1.2.0", project["name"], project["license"])
    assert cited["authors"] == project["authors"]
    assert cited["version"] == symcheck.__version__
    assert {"message", "type"} <= cited.keys()
