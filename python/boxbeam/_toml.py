"""A case as dictionaries, written as the TOML that the program reads."""

import json
import math
import re

_BARE = re.compile(r"[A-Za-z0-9_-]+")


def key(name):
    """A key as TOML has it."""
    if not isinstance(name, str):
        raise TypeError(f"a key is a text, not {name!r}")
    return name if _BARE.fullmatch(name) else text(name)


def text(words):
    """A text as TOML has it; its escapes are those of JSON, but for 0x7f."""
    return json.dumps(words, ensure_ascii=False).replace("\x7f", "\\u007f")


def value(of):
    """A value on one line."""
    if isinstance(of, bool):
        return "true" if of else "false"
    if isinstance(of, str):
        return text(of)
    if isinstance(of, dict):
        return "{ " + ", ".join(f"{key(name)} = {value(one)}" for name, one in of.items()) + " }" if of else "{}"
    if isinstance(of, (list, tuple)):
        return "[" + ", ".join(map(value, of)) + "]"
    if hasattr(of, "item"):  # a number of numpy
        of = of.item()
    if isinstance(of, int):
        return str(of)
    if isinstance(of, float) and math.isfinite(of):
        return repr(of)
    raise TypeError(f"{of!r} cannot stand in a case: write texts with units, numbers, true or false, lists, tables")


def _is_table_list(of):
    return isinstance(of, (list, tuple)) and len(of) > 0 and all(isinstance(one, dict) for one in of)


def _lines(table, path):
    for name, one in table.items():
        if not isinstance(one, dict) and not _is_table_list(one):
            yield f"{key(name)} = {value(one)}"
    for name, one in table.items():
        below = f"{path}.{key(name)}" if path else key(name)
        if isinstance(one, dict):
            yield f"[{below}]"
            yield from _lines(one, below)
        elif _is_table_list(one):
            for item in one:
                yield f"[[{below}]]"
                yield from _lines(item, below)


def document(table):
    """A dictionary as a TOML file, a line for each value, so that errors have a line that says something."""
    return "\n".join(_lines(table, "")) + "\n"
