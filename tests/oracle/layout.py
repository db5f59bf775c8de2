"""What a message looks like on the wire, and the values that one frame carries.

This is the vocabulary that the two encoders, the case generator and the vector
file share. Values are kept as bit patterns, never as Python floats: a pattern
survives every conversion, and it is what the vector file shows.
"""

from contextlib import suppress
from dataclasses import dataclass

SIZES = {
    "char": 1,
    "int8_t": 1,
    "uint8_t": 1,
    "uint8_t_mavlink_version": 1,
    "int16_t": 2,
    "uint16_t": 2,
    "int32_t": 4,
    "uint32_t": 4,
    "float": 4,
    "int64_t": 8,
    "uint64_t": 8,
    "double": 8,
}
"""Bytes of one element, by base type as the XML spells it."""

FLOATS = ("float", "double")

SIGNING_KEY = bytes(range(32))
"""The secret key of every signed vector."""

VERSIONS = ("v1", "v2", "signed")
"""The frames of one case; `v1` is absent where the id does not fit one byte."""


@dataclass(frozen=True)
class Field:
    """One field; `array` is `None` for a scalar, `offset` counts from the start of the payload."""

    name: str
    type: str
    array: int | None
    extension: bool
    offset: int

    @property
    def size(self):
        """Bytes of one element."""
        return SIZES[self.type]

    @property
    def count(self):
        """Elements on the wire."""
        return self.array or 1

    @property
    def end(self):
        """Offset of the first byte after the field."""
        return self.offset + self.size * self.count


@dataclass(frozen=True)
class Message:
    """One message, its fields in XML order."""

    id: int
    name: str
    crc_extra: int
    len_v1: int
    len_v2: int
    fields: tuple[Field, ...]

    @property
    def wire_fields(self):
        """The fields in the order of their bytes."""
        return sorted(self.fields, key=lambda field: field.offset)


@dataclass(frozen=True)
class Envelope:
    """What a frame says besides its payload; the last two stand in signed frames only."""

    sequence: int
    system: int
    component: int
    link: int
    timestamp: int


@dataclass(frozen=True)
class Case:
    """One set of values: for each field name the bit patterns of its elements."""

    name: str
    envelope: Envelope
    values: dict[str, tuple[int, ...]]


def messages_of_dump(document):
    """Messages by id from a `dump --json` document, so that its offsets can be put to the test.

    A message whose record is incomplete is left out.
    """
    messages = {}
    for record in document["messages"]:
        with suppress(KeyError):
            messages[record["id"]] = _message_of_dump(record)
    return messages


def _message_of_dump(record):
    numbers = (record[key] for key in ("id", "name", "crc_extra", "len_v1", "len_v2"))
    return Message(*numbers, tuple(map(_field_of_dump, record["fields"])))


def _field_of_dump(record):
    return Field(*(record[key] for key in ("name", "type", "array", "extension", "offset")))
