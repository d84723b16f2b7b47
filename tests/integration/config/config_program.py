"""scarab-config as a process, and the files it is about."""

import json
import os
import subprocess
import sys
from pathlib import Path

import yaml

SOURCE_ROOT = Path(__file__).resolve().parents[3]
CONFIG = SOURCE_ROOT / "config"
SCHEMAS = CONFIG / "schema"
KINDS = ("calibration", "logger", "plant", "premotor", "robot", "robot_bridge", "supervisor")  # the files in other folders are other programs'
SHIPPED = sorted(file for kind in KINDS for file in (CONFIG / kind).glob("*.yaml"))
REGENERATE = "run: scarab-config schema --all config/schema"
PROGRAM = os.environ.get("SCARAB_CONFIG") or sys.exit("SCARAB_CONFIG must name the program, as ctest does")


def scarab_config(*arguments, folder=SOURCE_ROOT):
    """Exit code, standard output, standard error."""
    done = subprocess.run([PROGRAM, *map(str, arguments)], cwd=folder, capture_output=True,
                          text=True, timeout=60)
    return done.returncode, done.stdout, done.stderr


def kind_of(file):
    return file.parent.name


def schema_of(kind):
    return json.loads((SCHEMAS / f"{kind}.json").read_text())


class _Yaml12(yaml.SafeLoader):
    """Numbers and truth values as YAML 1.2, editors and scarab-config read them; PyYAML is of 1.1."""


_Yaml12.yaml_implicit_resolvers = {}
_Yaml12.add_implicit_resolver("tag:yaml.org,2002:bool", yaml.resolver.re.compile(r"true$|false$"), list("tf"))
_Yaml12.add_implicit_resolver("tag:yaml.org,2002:int", yaml.resolver.re.compile(r"[-+]?[0-9]+$"),
                              list("-+0123456789"))
_Yaml12.add_implicit_resolver(
    "tag:yaml.org,2002:float",
    yaml.resolver.re.compile(r"[-+]?(\.[0-9]+|[0-9]+(\.[0-9]*)?)([eE][-+]?[0-9]+)?$"), list("-+.0123456789"))


def read_yaml(text):
    return yaml.load(text, _Yaml12)
