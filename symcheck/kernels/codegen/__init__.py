"""From expressions that are proved to functions: declarations, straight-line programs, and the targets they become."""

from pkgutil import iter_modules

SUFFIX = "_target"


def target_names() -> list[str]:
    """The names of all targets: each is a module `<name>_target`."""
    return sorted(module.name.removesuffix(SUFFIX) for module in iter_modules(__path__) if module.name.endswith(SUFFIX))
