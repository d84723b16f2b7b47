"""Every single mistake of some sorts that can be made in a file: the file's content with one thing changed."""

import copy


class Mutant:
    def __init__(self, path, what, content):
        self.name = f"{'.'.join(map(str, path)) or '(top level)'}: {what}"
        self.content = content


def places(value, path=()):
    """Every value below with its path, itself included; of a list, the list only."""
    yield path, value
    if isinstance(value, dict):
        for key, item in value.items():
            yield from places(item, path + (key,))


def schema_at(schema, path):
    """The part of a schema that speaks of the value at a path."""
    for key in path:
        schema = _map_part(schema)
        known = schema.get("properties", {})
        schema = known[key] if key in known else schema["additionalProperties"]
    return schema


def _map_part(schema):
    """Of `absent` or a map: the map."""
    return next(one for one in schema["anyOf"] if "const" not in one) if "anyOf" in schema else schema


def is_map_of_fixed_keys(schema):
    return _map_part(schema).get("additionalProperties") is False


def _changed(content, path, value):
    result = copy.deepcopy(content)
    at = result
    for key in path[:-1]:
        at = at[key]
    at[path[-1]] = value
    return result


def with_unknown_key(content, schema):
    for path, value in places(content):
        if not isinstance(value, dict) or not is_map_of_fixed_keys(schema_at(schema, path)):
            continue
        if path:
            yield Mutant(path, "unknown key", _changed(content, path, {**value, "nonsense": 1}))
        else:
            yield Mutant(path, "unknown key", {**content, "nonsense": 1})


def without_key(content, schema):
    """Required keys. Leaving an entry out of a map that takes any key is no mistake."""
    for path, value in places(content):
        if not isinstance(value, dict) or not is_map_of_fixed_keys(schema_at(schema, path)):
            continue
        for key in value:
            if "default" in schema_at(schema, path + (key,)):
                continue
            rest = {name: item for name, item in value.items() if name != key}
            yield Mutant(path + (key,), "left out", _changed(content, path, rest) if path else rest)


def of_wrong_type(content):
    for path, value in places(content):
        if not path:
            continue
        wrong = {dict: [1, "word", [1]], list: [1, "word", {"a": 1}], bool: ["word", 1, [True]],
                 int: ["word", True, [1]], float: ["word", True, [1.0]], str: [[1], {"a": 1}]}[type(value)]
        for other in wrong:
            yield Mutant(path, f"{other!r} in place of {value!r}", _changed(content, path, other))


def of_wrong_size(content, schema):
    for path, value in places(content):
        if isinstance(value, list) and "minItems" in schema_at(schema, path):
            yield Mutant(path, "one too few", _changed(content, path, value[:-1]))
            yield Mutant(path, "one too many", _changed(content, path, value + value[-1:]))


def with_other_name(content, schema):
    """In place of a name of an enumeration, none of it."""
    for path, _ in places(content):
        part = schema_at(schema, path)
        if "enum" in part:
            yield Mutant(path, "no such name", _changed(content, path, "nonsense"))
        elif "enum" in part.get("items", {}):
            yield Mutant(path, "no such name", _changed(content, path, ["nonsense"]))


def with_other_number(content, schema):
    """In place of each number, and of all numbers of a list: others on all sides of what limits there may be."""
    for path, value in places(content):
        part = schema_at(schema, path)
        is_list = isinstance(value, list)
        for number in _probes(part["items"] if is_list else part):
            yield Mutant(path, str(number), _changed(content, path, [number] * len(value) if is_list else number))


def _probes(part):
    """Whatever the schema says, so that a limit it has forgotten is found, and around the limits that it knows."""
    step = {"integer": 1, "number": 1e-3}.get(part.get("type"))
    if step is None:
        return []
    limits = [part[word] for word in ("minimum", "exclusiveMinimum", "maximum") if word in part]
    around = [limit + side * step for limit in limits for side in (-1, 0, 1)]
    return sorted({int(number) if step == 1 else float(number) for number in [-10**9, -1, 0, 1, 10**9, *around]})
