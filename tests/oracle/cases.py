"""The values that are put into every message: extremes, patterns, pseudo-random ones, and those at which encoders fail.

Everything follows from the names and types of a message. A pseudo-random number is a
hash of message, case, field and element, so that adding a message, a case or a field
changes no other value, whatever the version of Python.
"""

import hashlib
from itertools import cycle, islice

from layout import FLOATS, Case, Envelope

RANDOM_CASES = ("random_1", "random_2", "random_3")
QUIET_NANS = {"float": (0x7FC12345, 0xFFE54321), "double": (0x7FF8123456789ABC, 0xFFFCFEDCBA987654)}
INFINITIES = {"float": (0x7F800000, 0xFF800000), "double": (0x7FF0000000000000, 0xFFF0000000000000)}
EXPONENT = {"float": 0x7F800000, "double": 0x7FF0000000000000}
QUIET_BIT = {"float": 0x00400000, "double": 0x0008000000000000}
LARGEST_FINITE = {"float": 0x7F7FFFFF, "double": 0x7FEFFFFFFFFFFFFF}
LETTERS = b"abcdefghijklmnopqrstuvwxyz"


def cases_of(message):
    """Every case of a message, in a fixed order."""
    values = {
        "zero": _each(message, _zeros),
        "max": _each(message, _largest),
        "min": _each(message, _smallest),
        "first": _only(message, message.wire_fields[0], _counting),
        "last": _only(message, message.wire_fields[-1], _counting),
    }
    for name in RANDOM_CASES:
        values[name] = {field.name: _random(message, name, field) for field in message.fields}
    values.update(_float_cases(message))
    values.update(_text_cases(message))
    values.update(_truncation_cases(message))
    return [Case(name, _envelope(message, name), fields) for name, fields in values.items()]


def _float_cases(message):
    """NaN with a payload and both infinities, in turn with both signs, and the zero that truncation must not cut."""
    if not any(field.type in FLOATS for field in message.fields):
        return {}
    return {
        "nan": _floats(message, lambda field: _in_turn(field, QUIET_NANS[field.type])),
        "infinity": _floats(message, lambda field: _in_turn(field, INFINITIES[field.type])),
        "negative_zero": _floats(message, lambda field: (_sign_bit(field),) * field.count),
    }


def _text_cases(message):
    """Text that fills its array without a NUL, and text with something after a NUL."""
    if not any(field.type == "char" for field in message.fields):
        return {}
    return {"full": _texts(message, _full_text), "nul": _texts(message, _text_after_nul)}


def _truncation_cases(message):
    """Payloads whose trailing zeros begin inside a number, inside an array, and around the end of the base fields."""
    wire = message.wire_fields
    base = [field for field in wire if not field.extension]
    numbers = [field for field in wire if field.size > 1]
    arrays = [field for field in wire if field.count > 1]
    cuts = {}
    if numbers:
        cuts["cut_number"] = _single_byte(message, numbers[-1], numbers[-1].count - 1, numbers[-1].size // 2 - 1)
    if arrays:
        cuts["cut_array"] = _single_byte(message, arrays[-1], arrays[-1].count // 2 - 1, 0)
    if len(base) < len(wire):
        cuts["cut_base"] = _single_byte(message, base[-1], base[-1].count - 1, base[-1].size - 1)
        cuts["cut_extension"] = _single_byte(message, wire[len(base)], 0, 0)
    return cuts


def _each(message, fill):
    return {field.name: fill(field) for field in message.fields}


def _only(message, chosen, fill):
    """Zero everywhere but in one field."""
    return _each(message, lambda field: fill(field) if field == chosen else _zeros(field))


def _floats(message, fill):
    return _each(message, lambda field: fill(field) if field.type in FLOATS else _zeros(field))


def _texts(message, fill):
    return _each(message, lambda field: fill(field) if field.type == "char" else _zeros(field))


def _single_byte(message, chosen, element, byte):
    """Zero everywhere but in one byte; bytes of an element are counted as on the wire, the lowest first."""
    marked = [0] * chosen.count
    marked[element] = 0x3A << 8 * byte
    return _only(message, chosen, lambda field: tuple(marked))


def _zeros(field):
    return (0,) * field.count


def _largest(field):
    """All ones, the largest signed number, the largest finite float."""
    if field.type in FLOATS:
        return (LARGEST_FINITE[field.type],) * field.count
    ones = (1 << 8 * field.size) - 1
    return (ones >> 1 if field.type.startswith("int") else ones,) * field.count


def _smallest(field):
    """The most negative integer, the negative float next to zero, 1 where there is no sign, terminated text of `A`."""
    if field.type == "char":
        return (ord("A"),) * max(1, field.count - 1) + (0,) * (field.count > 1)
    if field.type in FLOATS:
        return (_sign_bit(field) | 1,) * field.count
    return (_sign_bit(field) if field.type.startswith("int") else 1,) * field.count


def _sign_bit(field):
    return 1 << 8 * field.size - 1


def _counting(field):
    """Bytes 1, 2, 3 … from the first element's highest, so that every byte and every element differs from the next."""
    numbers = bytes(islice(cycle(range(1, 256)), field.size * field.count))
    elements = (numbers[start : start + field.size] for start in range(0, len(numbers), field.size))
    return tuple(_quiet(field, int.from_bytes(element, "big")) for element in elements)


def _random(message, case, field):
    """Any bits at all, but for what `_quiet` sets right."""
    return tuple(_quiet(field, _draw(field.size, message.name, case, field.name, i)) for i in range(field.count))


def _quiet(field, bits):
    """A signalling NaN made quiet, because Python does so with a `float` that it packs; MAVLink would keep it."""
    if field.type in FLOATS and bits & EXPONENT[field.type] == EXPONENT[field.type]:
        return bits | QUIET_BIT[field.type]
    return bits


def _in_turn(field, patterns):
    """Both patterns in turn; which one is first depends on the name, so that scalars get both as well."""
    start = _draw(1, field.name) % 2
    return tuple(islice(cycle(patterns), start, start + field.count))


def _full_text(field):
    return tuple(islice(cycle(LETTERS), field.count))


def _text_after_nul(field):
    text = list(_full_text(field))
    text[field.count // 2] = 0
    return tuple(text)


def _envelope(message, case):
    """Everything zero or everything at its largest with the values that are so, else pseudo-random."""
    if case == "zero":
        return Envelope(0, 0, 0, 0, 0)
    if case == "max":
        return Envelope(0xFF, 0xFF, 0xFF, 0xFF, 0xFFFF_FFFF_FFFF)
    names = {"sequence": 1, "system": 1, "component": 1, "link": 1, "timestamp": 6}
    return Envelope(*(_draw(size, message.name, case, name) for name, size in names.items()))


def _draw(size, *key):
    """A number of `size` bytes that only its key decides."""
    return int.from_bytes(hashlib.sha256("/".join(map(str, key)).encode()).digest()[:size], "big")
