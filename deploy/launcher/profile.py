"""A profile of stack.yaml: which services are started here, and what else belongs to the stack."""

from dataclasses import dataclass
from typing import Dict, Tuple

from .stack import Service
from .strict_yaml import Value

Services = Dict[str, Service]
Members = Tuple[Service, ...]


@dataclass(frozen=True)
class Profile:
    """Each in the order of starting. `emulated` is hardware that can be started with the rest."""

    here: Members
    elsewhere: Members
    emulated: Members

    def with_emulated(self, services: Services) -> Members:
        """Those of here and the emulated hardware, in the order of `services`."""
        return tuple(s for s in services.values() if s in self.here or s in self.emulated)

    def drives_a_device(self) -> bool:
        return any(s.device for s in self.here)


def read_profile(value: Value, services: Services) -> Profile:
    """ConfigError where its members do not go together."""
    fields = value.mapping()
    here, elsewhere, emulated = (_members(fields[key], services) if key in fields else ()
                                 for key in ("services", "elsewhere", "emulated"))
    for service in (*here, *elsewhere):
        if service.hardware:
            value.fail(f"'{service.name}' is hardware, and belongs under `emulated`")
        if service in here and service in elsewhere:
            value.fail(f"service '{service.name}' is both here and elsewhere")
    clocks = [s.name for s in (*here, *elsewhere) if s.tick_master]
    if len(clocks) > 1:
        value.fail(f"has {len(clocks)} tick masters ({', '.join(clocks)}); there can be just one")
    profile = Profile(here, elsewhere, emulated)
    for service in emulated:
        if not service.hardware:
            fields["emulated"].fail(f"'{service.name}' is a service; expected one with `hardware: true`")
        if not profile.drives_a_device():
            fields["emulated"].fail("there is no tick master with `device: true` here, whose device it could be")
    return profile


def _members(value: Value, services: Services) -> Members:
    names = []
    for item in value.sequence():
        name = item.choice(services)
        if name in names:
            item.fail(f"service '{name}' is listed twice")
        names.append(name)
    order = list(services)
    if names != sorted(names, key=order.index):
        value.fail("must be in the order of `services`, which is the order of starting")
    return tuple(services[name] for name in names)
