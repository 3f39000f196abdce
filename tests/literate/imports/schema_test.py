#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""schema_test.py SOURCE_DIR: results.schema.json takes what the paper's programs wrote in Octave, and refuses what
import_json refuses (tests/literate/imports/import_json_test.cpp)."""

import json
import pathlib
import sys

import jsonschema

from claims import claim, finish

source = pathlib.Path(sys.argv[1])
schema = json.loads((source / "src/literate/imports/results.schema.json").read_text())
validator = jsonschema.Draft202012Validator(schema)


def takes(values=None, columns=None, rows=(), **more):
    content = {"script": "run.m", **more}
    if values is not None:
        content["values"] = values
    if columns is not None:
        content["tables"] = {"t": {"columns": columns, "rows": list(rows)}}
    return validator.is_valid(content)


jsonschema.Draft202012Validator.check_schema(schema)
results = sorted((source / "report/octave").glob("*.json"))
claim("there are results to look at", len(results) == 2)
for file in results:
    claim(f"{file.name} is taken", validator.is_valid(json.loads(file.read_text())))

number = {"value": 1.5, "abs_error": 0.1}
claim("a number with its error is taken", takes({"a.b": number}))
claim("a text is taken", takes({"a": {"text": "x"}}))
claim("a table is taken", takes(columns=[{"heading": "x", "decimals": 2, "exponent": -6, "exact": True}], rows=[[1], [number], [None]]))
claim("a column prints its errors", takes(columns=[{"heading": "x", "uncertain": True}], rows=[[number]]))
claim("or has digits", not takes(columns=[{"heading": "x", "uncertain": True, "digits": 2}]))
claim("an unknown field is refused", not takes(vales={}))
claim("no script is refused", not validator.is_valid({"values": {}}))
claim("a number without an error is refused", not takes({"a": {"value": 1}}))
claim("a negative error is refused", not takes({"a": {"value": 1, "abs_error": -1}}))
claim("null is no number", not takes({"a": {"value": None, "abs_error": 0}}))
claim("no digits are refused", not takes({"a": {**number, "digits": 0}}))
claim("a unit in LaTeX is refused", not takes({"a": {**number, "unit": "\\mm"}}))
claim("a key with a blank is refused", not takes({"a b": number}))
claim("a column with two formats is refused", not takes(columns=[{"heading": "x", "digits": 2, "text": True}]))
claim("an exponent without decimals is refused", not takes(columns=[{"heading": "x", "exponent": 3}]))
claim("a table without columns is refused", not takes(columns=[]))
finish()
