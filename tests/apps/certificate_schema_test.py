"""docs/certificate.schema.json describes the certificates that limes writes: certificate_schema_test.py SCHEMA LIMES DATA

Every certificate of every theorem fits, and what limes-check rejects for its form does not. A small reader of the part of
JSON Schema that the schema uses; python3-jsonschema must agree where it is installed.
"""
import copy
import json
import pathlib
import re
import subprocess
import sys
import tempfile

try:
    import jsonschema
except ImportError:
    jsonschema = None

schema_file, limes, data = sys.argv[1:4]
SCHEMA = json.loads(pathlib.Path(schema_file).read_text())
TYPES = {"object": dict, "array": list, "string": str}


def fits(value, schema):
    """Whether a value is valid by a schema; an unknown keyword is a failure of the test."""
    for key, rule in schema.items():
        if key in ("$schema", "$defs", "title", "description"):
            continue
        if key == "$ref":
            ok = fits(value, SCHEMA["$defs"][rule.removeprefix("#/$defs/")])
        elif key == "type" and rule == "integer":
            ok = isinstance(value, int) and not isinstance(value, bool)
        elif key == "type":
            ok = isinstance(value, TYPES[rule])
        elif key == "const":
            ok = type(value) is type(rule) and value == rule
        elif key == "enum":
            ok = any(type(value) is type(choice) and value == choice for choice in rule)
        elif key == "oneOf":
            ok = sum(fits(value, choice) for choice in rule) == 1
        elif key == "anyOf":
            ok = any(fits(value, choice) for choice in rule)
        elif key == "allOf":
            ok = all(fits(value, choice) for choice in rule)
        elif key == "not":
            ok = not fits(value, rule)
        elif key in ("pattern", "minLength", "maxLength"):
            ok = not isinstance(value, str) or {"pattern": lambda: re.search(rule, value) is not None,
                                                "minLength": lambda: len(value) >= rule,
                                                "maxLength": lambda: len(value) <= rule}[key]()
        elif key in ("minimum", "maximum"):
            ok = not isinstance(value, int) or (value >= rule if key == "minimum" else value <= rule)
        elif key in ("items", "prefixItems", "minItems", "maxItems", "uniqueItems"):
            ok = not isinstance(value, list) or {
                "items": lambda: all(fits(x, rule) for x in value),
                "prefixItems": lambda: all(fits(x, r) for x, r in zip(value, rule)),
                "minItems": lambda: len(value) >= rule,
                "maxItems": lambda: len(value) <= rule,
                "uniqueItems": lambda: len(set(map(json.dumps, value))) == len(value)}[key]()
        elif key in ("properties", "required", "additionalProperties", "minProperties", "maxProperties", "propertyNames"):
            known = schema.get("properties", {})
            ok = not isinstance(value, dict) or {
                "properties": lambda: all(fits(value[k], r) for k, r in rule.items() if k in value),
                "required": lambda: all(k in value for k in rule),
                "additionalProperties": lambda: all(k in known or (rule is not False and fits(x, rule))
                                                    for k, x in value.items()),
                "minProperties": lambda: len(value) >= rule,
                "maxProperties": lambda: len(value) <= rule,
                "propertyNames": lambda: all(fits(k, rule) for k in value)}[key]()
        else:
            sys.exit(f"the test does not know the keyword {key}")
        if not ok:
            return False
    return True


def is_valid(certificate):
    result = fits(certificate, SCHEMA)
    if jsonschema:
        assert result == jsonschema.Draft202012Validator(SCHEMA).is_valid(certificate), "jsonschema disagrees"
    return result


ONE_SIDED = """name = "one-sided"
kind = "nonuniform"
[nonuniform]
points = 4
[nonuniform.rule]
new = "9/16*at(f(2,0),1/2) + 7/16*at(f(2,1),1/2)"
[[claims]]
claim = "C1"
"""
BY_COEFFICIENTS = """name = "by-coefficients"
kind = "nonuniform"
[nonuniform]
points = 2
[nonuniform.rule]
coefficients = ["1/2", "1/2"]
[[claims]]
claim = "C0"
[[claims]]
claim = "not C1"
"""

# (1 + z^2) times the mask of the hat function, halved: its shifts are linearly dependent.
UNSTABLE = """name = "unstable"
kind = "uniform"
[uniform]
first_index = 0
mask = ["1/4", "1/2", "1/2", "1/2", "1/4"]
"""

certificates = {path.name: json.loads(path.read_text()) for path in pathlib.Path(data).glob("*.json")}
with tempfile.TemporaryDirectory() as directory:
    for name, text in (("one", ONE_SIDED), ("two", BY_COEFFICIENTS)):
        pathlib.Path(directory, name + ".toml").write_text(text)
    subprocess.run([limes, "verify", "four-point", "cr1", "a1-3-1", directory + "/one.toml", directory + "/two.toml",
                    "unified-curve", "--certificates", directory, "--quiet"], check=True, stdout=subprocess.DEVNULL)
    for claim in ("reproduces {1, y^2}", "does not reproduce {y}"):
        subprocess.run([limes, "verify", "unified-curve", "--claim", claim, "--certificates", directory, "--quiet"], check=False,
                       stdout=subprocess.DEVNULL)
    for scheme, claim, valences in (("catmull-clark", "C1", "[3, inf)"), ("doo-sabin", "C1", "[3, 5]"), ("doo-sabin", "spectral-condition", "4")):
        subprocess.run([limes, "verify", scheme, "--claim", claim, "--valence", valences, "--certificates", directory, "--quiet"], check=True,
                       stdout=subprocess.DEVNULL)
        for path in pathlib.Path(directory).glob(scheme + ".asked*.json"):
            path.rename(path.with_name(f"{scheme}.{claim}.{len(valences)}.json"))
    subprocess.run([limes, "verify", "unified", "--param", "theta=0", "--certificates", directory, "--quiet"], check=True,
                   stdout=subprocess.DEVNULL)
    # Exact and enclosed exponents, with and without a proof of stability, and radii with and without blocks.
    pathlib.Path(directory, "three.toml").write_text(UNSTABLE)
    for name, word in (("pair", [[["1", "1"], ["0", "1"]], [["1", "0"], ["1", "1"]]]), ("turn", [[["3/5", "-4/5"], ["4/5", "3/5"]]])):
        pathlib.Path(directory, name + ".txt").write_text(json.dumps(word))
        subprocess.run([limes, "jsr", directory + f"/{name}.txt", "--digits", "3", "--certificates", directory, "--quiet"], check=True,
                       stdout=subprocess.DEVNULL)
    for arguments in (["four-point", "--param", "w=1/16"], ["deslauriers-dubuc-6"], ["six-point", "--param", "w=1/50", "--digits", "3"],
                      [directory + "/three.toml"]):
        subprocess.run([limes, "holder", *arguments, "--certificates", directory, "--quiet"], check=False, stdout=subprocess.DEVNULL)
    for claim in ("only zero limits", "not C0", "C0", "projective C0", "not projective C0", "not projective C1", "projective C1"):
        subprocess.run([limes, "verify", "cinpact-3", "--claim", claim, "--certificates", directory, "--quiet"], check=False, stdout=subprocess.DEVNULL)
    subprocess.run([limes, "multiresolution", "chaikin", "--extension", "2", "--certificates", directory, "--quiet"], check=True, stdout=subprocess.DEVNULL)
    for path in pathlib.Path(directory).glob("*.json"):
        certificates[path.name] = json.loads(path.read_text())

assert {c["theorem"] for c in certificates.values()} == {"U1", "U2", "U3", "N1", "N3", "S1", "S2", "P0", "P1", "P2", "E1", "E2", "B1", "JSR"}
assert {c["verdict"] for c in certificates.values() if c["theorem"] == "P0"} == {"certified", "refuted"}
assert any("mirrored" in c["proof"] for c in certificates.values())
assert any("coefficients" in c.get("scheme", {}) for c in certificates.values())
for theorem in ("U3", "JSR"):
    own = [c for c in certificates.values() if c["theorem"] == theorem]
    assert {"polynomial" in c["claim"] for c in own} == {True, False}, f"{theorem}: exact and enclosed"
assert any(c["theorem"] == "U3" and "upper" not in c["claim"] for c in certificates.values())
for name, certificate in certificates.items():
    assert is_valid(certificate), f"{name} does not fit the schema"


def objects(value, path=()):
    """The paths of all objects below a value but regions, whose keys are the scheme's own."""
    if isinstance(value, dict) and (not path or path[-1] != "region"):
        yield path
    for key, child in value.items() if isinstance(value, dict) else enumerate(value) if isinstance(value, list) else ():
        yield from objects(child, path + (key,))


OPTIONAL = {"c", "distances", "mirrored", "touch", "polynomial in claim"}
for name, certificate in certificates.items():
    for path in objects(certificate):
        changed = copy.deepcopy(certificate)
        target = changed
        for step in path:
            target = target[step]
        for own in [*target.keys()]:
            kept = target.pop(own)
            assert own in OPTIONAL or " in ".join((own, *map(str, path))) in OPTIONAL or not is_valid(changed), f"{name} without {own} in {path} fits the schema"
            target[own] = {"kept": kept}
            assert not is_valid(changed), f"{name} with an object as {own} in {path} fits the schema"
            target[own] = kept
        target["more"] = 1
        assert not is_valid(changed), f"{name} with one more key in {path} fits the schema"
    for theorem in ("U1", "U2", "U3", "N1", "N2", "N3", "S1", "S2", "P0", "P1", "P2", "E1", "E2", "B1", "JSR"):
        for verdict in ("certified", "refuted", "undecided"):
            if (theorem, verdict) == (certificate["theorem"], certificate.get("verdict")):
                continue
            changed = copy.deepcopy(certificate)
            changed["theorem"], changed["verdict"] = theorem, verdict
            assert not is_valid(changed), f"{name} as {verdict} by {theorem} fits the schema"
print(f"{len(certificates)} certificates fit the schema")
