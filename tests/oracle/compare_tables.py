"""Compares the Parquet tables of `mavgen decode` with its CSV tables, cell by cell, as DuckDB reads them.

usage: compare_tables.py --mavgen MAVGEN --xml XML [--overlay XML] --expect TABLES LOG…

Then it asks one question of all logs at once, which is what such tables are for.
"""

import argparse
import csv
import json
import struct
import subprocess
import sys
import tempfile
from pathlib import Path

import duckdb

WHOLE = {"UTINYINT", "TINYINT", "USMALLINT", "SMALLINT", "UINTEGER", "INTEGER", "UBIGINT", "BIGINT"}


def decode(arguments, log, kind, folder):
    """Runs mavgen."""
    overlay = ["--overlay", arguments.overlay] if arguments.overlay else []
    command = [arguments.mavgen, "decode", arguments.xml, *overlay, log, "--format", kind, "--out", folder]
    subprocess.run(command, check=True, stderr=subprocess.DEVNULL)


def bits(kind, value):
    """A number by its bits, so that NaNs and signed zeros are compared as well."""
    return struct.pack("<f" if kind == "FLOAT" else "<d", float(value))


def is_same(kind, text, value):
    """Whether a cell of a CSV file says what a typed value is."""
    if value is None:
        return text == ""
    if kind in WHOLE:
        return text == str(value)
    if kind in ("FLOAT", "DOUBLE"):
        return text != "" and (bits(kind, text) == bits(kind, value) or float(text) != float(text) and value != value)
    return text == (str(value).lower() if kind == "BOOLEAN" else value)


def compare(csv_path, parquet_path):
    """Compares two tables; the number of cells."""
    with open(csv_path, newline="") as file:
        header, *rows = csv.reader(file)
    source = f"'{parquet_path}'"
    types = {name: kind for name, kind, *_ in duckdb.sql(f"DESCRIBE SELECT * FROM {source}").fetchall()}
    metadata = dict(duckdb.sql(f"SELECT decode(key), decode(value) FROM parquet_kv_metadata({source})").fetchall())
    units, names = json.loads(metadata["units"]), list(types)
    if metadata["message"] != parquet_path.stem or types["time"] != "TIMESTAMP WITH TIME ZONE":
        sys.exit(f"{parquet_path}: {metadata['message']}, time is {types['time']}")
    expected = [f"{name} ({units[name]})" if name in units else name for name in names[1:]]
    if header[2:] != expected:
        sys.exit(f"{parquet_path}: columns {expected}, not {header[2:]}")
    typed = duckdb.sql(f"SELECT * REPLACE (epoch_us(time) AS time) FROM {source}").fetchall()
    if len(typed) != len(rows):
        sys.exit(f"{parquet_path}: {len(typed)} rows, not {len(rows)}")
    for number, (row, values) in enumerate(zip(rows, typed), 2):
        time = "" if values[0] is None else f"{values[0] // 1_000_000}.{values[0] % 1_000_000:06}"
        wrong = [name for name, text, value in zip(names[1:], row[2:], values[1:]) if not is_same(types[name], text, value)]
        if wrong or row[1] != time:
            sys.exit(f"{csv_path}:{number}: {wrong or 'time'}: {row}, not {values}")
    return len(typed) * len(names)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--mavgen", required=True)
    parser.add_argument("--xml", required=True)
    parser.add_argument("--overlay")
    parser.add_argument("--expect", type=int, required=True, help="how many tables there are, of all logs together")
    parser.add_argument("logs", nargs="+")
    arguments = parser.parse_args()
    tables, cells = 0, 0
    with tempfile.TemporaryDirectory() as scratch:
        for index, log in enumerate(arguments.logs):
            typed, text = Path(scratch, "parquet", str(index)), Path(scratch, "csv", str(index))
            decode(arguments, log, "parquet", typed)
            decode(arguments, log, "csv", text)
            if {path.stem for path in typed.iterdir()} != {path.stem for path in text.iterdir()}:
                sys.exit(f"{log}: not the same tables")
            for path in sorted(typed.iterdir()):
                cells += compare(text / f"{path.stem}.csv", path)
                tables += 1
            # An earlier run's tables are replaced.
            decode(arguments, log, "parquet", typed)
        if tables != arguments.expect:
            sys.exit(f"{tables} tables, not {arguments.expect}")
        print(f"{cells} typed cells of {tables} tables are what CSV says")
        beats = f"read_parquet('{scratch}/parquet/*/HEARTBEAT.parquet', filename = true)"
        rows = duckdb.sql(f"SELECT count(DISTINCT filename), count(*), min(time), max(time) FROM {beats}").fetchall()[0]
        if rows[0] != len(arguments.logs):
            sys.exit(f"DuckDB reads {rows[0]} logs, not {len(arguments.logs)}")
        print(f"DuckDB finds {rows[1]} heartbeats in {rows[0]} logs")


if __name__ == "__main__":
    main()
