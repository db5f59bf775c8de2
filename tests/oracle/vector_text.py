"""The text of a vector file; `make_vectors.py` describes the format."""

from itertools import groupby, pairwise

from layout import VERSIONS

SHORTEST_RUN = 4
"""Repetitions from which `unit*count` is shorter than the units themselves, commas included."""

HEADER_LENGTH = {"v1": 6, "v2": 10, "signed": 10}
CHECKSUM_LENGTH = 2


def message_lines(message, cases):
    """The lines of one message: its header, then each case with its frames; `cases` are (case, frames) pairs."""
    yield ""
    yield _message_header(message)
    for case, frames in cases:
        yield f"case {case.name} {_envelope(case.envelope)}"
        yield "values " + " ".join(_values(field, case) for field in message.fields)
        for version in VERSIONS:
            if version in frames:
                yield f"{version} {_frame(frames[version], HEADER_LENGTH[version])}"


def _message_header(message):
    facts = f"message {message.id} {message.name}"
    facts += f" crc_extra={message.crc_extra} len_v2={message.len_v2} len_v1={message.len_v1}"
    return " ".join([facts, *map(_field, message.fields)])


def _field(field):
    array = "" if field.array is None else f"[{field.array}]"
    return f"{'+' if field.extension else ''}{field.name}:{field.type}{array}"


def _envelope(envelope):
    ids = (envelope.sequence, envelope.system, envelope.component, envelope.link)
    return " ".join([*(f"{number:02x}" for number in ids), f"{envelope.timestamp:012x}"])


def _values(field, case):
    return _runs([f"{bits:0{2 * field.size}x}" for bits in case.values[field.name]])


def _frame(frame, header_length):
    """Header, payload, checksum and, if there is one, the signature block, apart for the reader's sake."""
    payload_end = header_length + frame[1]
    ends = (header_length, payload_end, payload_end + CHECKSUM_LENGTH, len(frame))
    parts = (frame[start:end] for start, end in pairwise((0, *ends)))
    return " ".join(_runs([f"{byte:02x}" for byte in part]) for part in parts if part)


def _runs(units):
    """Units in a row, runs of one unit as `unit*count`; commas stand on both sides of a run."""
    tokens = [""]
    for unit, repeated in groupby(units):
        count = len(list(repeated))
        if count < SHORTEST_RUN:
            tokens[-1] += unit * count
        else:
            tokens += [f"{unit}*{count}", ""]
    return ",".join(filter(None, tokens))
