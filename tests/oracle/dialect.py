"""pymavlink as the oracle: the model that it resolves from an XML file, and the frames that its code packs.

Both come out of `mavgen.mavgen` itself, the same entry as the command line has,
so that includes, enum merging and validation are pymavlink's own. It evaluates
text of the XML as Python: give it files that you trust.
"""

import contextlib
import importlib.util
import io
import os
import re
import struct
import tempfile
from pathlib import Path
from unittest import mock

import lxml.etree  # noqa: F401  (without it mavgen leaves validation out and says so only in passing)
from pymavlink.generator import mavgen, mavgen_python

from layout import FLOATS, SIGNING_KEY

CHATTER = re.compile("(Validating|Parsing|Validation skipped|Merged enum|Note:) |.*bitmask must have powers of 2")
"""The lines that pymavlink prints when all is well."""

COMPLAINT_LINES = 5
"""Lines of a complaint that are repeated; a schema error can come once for each message."""


class Refused(Exception):
    """pymavlink does not accept the definition; the text is what it says about it."""


def run_mavgen(xml, output, wire_protocol, validate, language="Python"):
    """Run the generator; it reports by printing, by returning false and by leaving the process."""
    log = io.StringIO()
    options = mavgen.Opts(str(output), wire_protocol, language=language, validate=validate)
    with contextlib.redirect_stdout(log), contextlib.redirect_stderr(log):
        try:
            accepted = mavgen.mavgen(options, [os.path.abspath(xml)])
        except SystemExit as leaving:
            accepted = False
            print(leaving.code)
        except Exception as error:
            raise Refused(f"{type(error).__name__}: {error}") from error
    if not accepted:
        raise Refused(_complaint(log.getvalue()))


def _complaint(log):
    """What is left of pymavlink's output without the progress report."""
    lines = [line for line in log.splitlines() if not CHATTER.match(line)]
    return "\n".join(lines[:COMPLAINT_LINES])


def resolve(xml, validate=True):
    """The files of a dialect as pymavlink's back ends get them: includes read, enums merged, duplicates refused.

    Wire protocol 2.0, because 1.0 drops extensions and ids above 255.
    """
    with mock.patch.object(mavgen_python, "generate") as back_end:
        run_mavgen(xml, "unused", "2.0", validate)
    return back_end.call_args.args[1]


def resolve_leniently(xml):
    """`resolve`, and where validation refuses, again without; also returns the reason, or `None`."""
    try:
        return resolve(xml), None
    except Refused as refusal:
        return resolve(xml, validate=False), str(refusal)


class Encoder:
    """Packs frames with the code that pymavlink generates from a definition.

    MAVLink 1 frames come from a module of wire protocol 1.0: a 2.0 module that is
    forced to version 1 sends the extension fields too, which version 1 must not.
    """

    def __init__(self, xml):
        with tempfile.TemporaryDirectory() as folder:
            #: The generated modules by wire protocol.
            self.modules = {wire: load_module(xml, wire, folder) for wire in ("1.0", "2.0")}

    def frames(self, message, case):
        """The frames of one case by version; no `v1` where the wire protocol 1.0 lacks the message."""
        made = {
            "v2": self._pack("2.0", message, case, signed=False),
            "signed": self._pack("2.0", message, case, signed=True),
        }
        if message.id in self.modules["1.0"].mavlink_map:
            made["v1"] = self._pack("1.0", message, case, signed=False)
        return made

    def _pack(self, wire_protocol, message, case, signed):
        """Always constructs: decoding and packing again fails for a scalar char and for arrays of one element."""
        module = self.modules[wire_protocol]
        message_class = module.mavlink_map[message.id]
        fields = {field.name: field for field in message.fields}
        arguments = [_python_value(fields[name], case.values[name]) for name in message_class.fieldnames]
        sender = module.MAVLink(None, case.envelope.system, case.envelope.component)
        sender.seq = case.envelope.sequence
        if signed:
            sender.signing.secret_key = SIGNING_KEY
            sender.signing.link_id = case.envelope.link
            sender.signing.timestamp = case.envelope.timestamp
            sender.signing.sign_outgoing = True
        return message_class(*arguments).pack(sender)


def load_module(xml, wire_protocol, folder):
    """Generate and import the Python module of a dialect."""
    name = f"pymavlink_{wire_protocol.replace('.', '_')}"
    path = Path(folder) / f"{name}.py"
    run_mavgen(xml, path, wire_protocol, validate=True)
    spec = importlib.util.spec_from_file_location(name, path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def generate_c(xml, folder):
    """Generate the C library of a dialect."""
    run_mavgen(xml, folder, "2.0", validate=True, language="C")


def _python_value(field, patterns):
    """What a pymavlink constructor takes for these bit patterns."""
    if field.type == "char":
        return bytes(patterns)
    elements = [_python_element(field, bits) for bits in patterns]
    return elements if field.array else elements[0]


def _python_element(field, bits):
    encoded = bits.to_bytes(field.size, "little")
    if field.type in FLOATS:
        return struct.unpack("<f" if field.type == "float" else "<d", encoded)[0]
    return int.from_bytes(encoded, "little", signed=not field.type.startswith("u"))
