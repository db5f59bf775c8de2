"""pymavlink as the oracle of decoding: what the code that it generates reads in a frame."""

import tempfile
from dataclasses import dataclass

from dialect import load_module
from layout import FLOATS


@dataclass(frozen=True)
class ReadField:
    """A field of a decoded message; `enum` are the values of its entries by name, if it carries an enum."""

    name: str
    type: str
    value: object
    enum: dict | None

    @property
    def is_float(self):
        """Whether it is a float or a double."""
        return self.type in FLOATS


@dataclass(frozen=True)
class Read:
    """A decoded message; `entries` are the values of all entries of all enums by name."""

    time: int
    system: int
    component: int
    sequence: int
    id: int
    name: str
    fields: list
    entries: dict


class Decoder:
    """Decodes frames with the code that pymavlink generates from a definition."""

    def __init__(self, xml):
        with tempfile.TemporaryDirectory() as folder:
            self._module = load_module(xml, "2.0", folder)
        enums = self._module.enums
        self._enums = {name: {entry.name: value for value, entry in enums[name].items()} for name in enums}
        self._entries = {entry: value for values in self._enums.values() for entry, value in values.items()}

    def decode(self, time, frame):
        """The message of a frame; `None` where pymavlink refuses it: an unknown id, or another checksum."""
        try:
            message = self._module.MAVLink(None).decode(bytearray(frame))
        except self._module.MAVError:
            return None
        if isinstance(message, self._module.MAVLink_unknown):
            return None
        fields = [self._field(message, index) for index in range(len(message.fieldnames))]
        sender = (message.get_srcSystem(), message.get_srcComponent(), message.get_seq())
        return Read(time, *sender, message.get_msgId(), message.get_type(), fields, self._entries)

    def _field(self, message, index):
        name = message.fieldnames[index]
        values = self._enums.get(message.fieldenums_by_name.get(name))
        return ReadField(name, message.fieldtypes[index], getattr(message, name), values)
