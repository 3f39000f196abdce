#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""specifications.py FOLDER: holds ro-crate-metadata.json and codecheck.yml of a folder against what their
specifications demand, and against the files that lie there; one line for each demand that is not met."""

import hashlib
import json
import pathlib
import re
import sys
import urllib.parse

import jsonschema
import yaml

REFERENCE = {
    "type": "object",
    "properties": {"@id": {"type": "string", "minLength": 1}},
    "required": ["@id"],
    "additionalProperties": False,
}
REFERENCES = {"anyOf": [REFERENCE, {"type": "array", "items": REFERENCE}]}
TEXT = {"type": "string", "minLength": 1}

# RO-Crate 1.1, appendix RO-Crate JSON-LD: a flat graph of entities under the context of the specification.
CRATE = {
    "type": "object",
    "required": ["@context", "@graph"],
    "properties": {
        "@context": {
            "type": "array",
            "prefixItems": [{"const": "https://w3id.org/ro/crate/1.1/context"}, {"type": "object"}],
        },
        "@graph": {
            "type": "array",
            "items": {
                "type": "object",
                "required": ["@id", "@type"],
                # Flattened: a property is a value, or a reference and nothing more.
                "additionalProperties": {
                    "anyOf": [REFERENCES, {"type": ["string", "number", "boolean"]},
                              {"type": "array", "items": {"type": "string"}}]
                },
                "properties": {"@id": TEXT},
            },
        },
    },
}
# RO-Crate 1.1, Root Data Entity.
ROOT = {
    "type": "object",
    "required": ["name", "description", "datePublished", "license", "hasPart"],
    "properties": {
        "@id": {"const": "./"},
        "@type": {"const": "Dataset"},
        "name": TEXT,
        "description": TEXT,
        "datePublished": {"type": "string", "pattern": r"^\d{4}-\d{2}-\d{2}(T\d{2}:\d{2}:\d{2}Z)?$"},
        "license": REFERENCE,
        "hasPart": REFERENCES,
        "author": REFERENCES,
    },
}
DESCRIPTOR = {
    "type": "object",
    "required": ["about", "conformsTo"],
    "properties": {
        "@type": {"const": "CreativeWork"},
        "about": {"const": {"@id": "./"}},
        "conformsTo": {"const": {"@id": "https://w3id.org/ro/crate/1.1"}},
    },
}
FILE = {
    "type": "object",
    "required": ["name", "contentSize", "sha256"],
    "properties": {
        "contentSize": {"type": "string", "pattern": r"^\d+$"},
        "sha256": {"type": "string", "pattern": "^[0-9a-f]{64}$"},
        "encodingFormat": {"type": "string", "pattern": "^[a-z]+/[a-z0-9.+-]+$"},
    },
}
# RO-Crate 1.1, Provenance of entities.
ACTION = {"type": "object", "required": ["name", "agent", "instrument", "object", "result"],
          "properties": {p: REFERENCES for p in ("agent", "instrument", "object", "result")}}
SOFTWARE = {"type": "object", "required": ["name", "version"]}
PERSON = {"type": "object", "required": ["name"]}

# CODECHECK configuration file 1.0, of which the author writes these parts.
CODECHECK = {
    "type": "object",
    "required": ["manifest", "version", "paper"],
    "properties": {
        "version": {"const": "https://codecheck.org.uk/spec/config/1.0/"},
        "manifest": {
            "type": "array",
            "minItems": 1,
            "items": {
                "type": "object",
                "required": ["file"],
                "properties": {"file": TEXT, "comment": TEXT},
                "additionalProperties": False,
            },
        },
        "paper": {
            "type": "object",
            "required": ["title", "authors"],
            "properties": {
                "title": TEXT,
                "reference": TEXT,
                "authors": {
                    "type": "array",
                    "minItems": 1,
                    "items": {
                        "type": "object",
                        "required": ["name"],
                        "properties": {
                            "name": TEXT,
                            "ORCID": {"type": "string", "pattern": r"^(\d{4}-){3}\d{3}[\dX]$"},
                        },
                    },
                },
            },
        },
        "source": TEXT,
        "repository": TEXT,
    },
    "additionalProperties": False,
}

problems = []


def demand(holds, text):
    if not holds:
        problems.append(text)


def follows(schema, value, what):
    for error in jsonschema.Draft202012Validator(schema).iter_errors(value):
        problems.append(f"{what}: {error.json_path}: {error.message[:200]}")


def types_of(entity):
    return entity["@type"] if isinstance(entity["@type"], list) else [entity["@type"]]


def references_of(value):
    if isinstance(value, dict):
        return [value["@id"]]
    if isinstance(value, list):
        return [entry["@id"] for entry in value if isinstance(entry, dict)]
    return []


def check_crate(folder):
    text = (folder / "ro-crate-metadata.json").read_text(encoding="utf-8")
    crate = json.loads(text)
    follows(CRATE, crate, "crate")
    entities = {}
    for entity in crate["@graph"]:
        demand(entity["@id"] not in entities, f"{entity['@id']} is described twice")
        entities[entity["@id"]] = entity
        demand("../" not in entity["@id"], f"{entity['@id']} climbs out of the crate")
        demand(re.fullmatch(r"[^ <>\"{}|\\^`]+", entity["@id"]), f"{entity['@id']} is no URI reference")

    follows(DESCRIPTOR, entities.get("ro-crate-metadata.json", {}), "descriptor")
    root = entities.get("./", {})
    follows(ROOT, root, "root")
    for entity in entities.values():
        for name, value in entity.items():
            for target in references_of(value):
                is_known = target in entities or name == "conformsTo"
                demand(is_known, f"{entity['@id']}: {name} refers to {target}, which is not described")

    parts = references_of(root.get("hasPart"))
    for name, entity in entities.items():
        for kind, schema in (("File", FILE), ("CreateAction", ACTION), ("SoftwareApplication", SOFTWARE),
                             ("Person", PERSON), ("Organization", PERSON)):
            if kind in types_of(entity):
                follows(schema, entity, name)
        if "File" not in types_of(entity):
            continue
        demand(name in parts, f"{name} is a file that hasPart does not reach")
        path = folder / urllib.parse.unquote(name)
        demand(path.is_file(), f"{name} is not there")
        if path.is_file():
            data = path.read_bytes()
            demand(entity["contentSize"] == str(len(data)), f"{name} has another size")
            demand(entity["sha256"] == hashlib.sha256(data).hexdigest(), f"{name} has another digest")
    for path in folder.rglob("*"):
        name = path.relative_to(folder).as_posix()
        if path.is_file() and name != "ro-crate-metadata.json":
            demand(urllib.parse.quote(name, safe="/!$&'()*+,;=@~") in parts, f"{name} is not described")
    actions = [entity for entity in entities.values() if "CreateAction" in types_of(entity)]
    demand(len(actions) == 1, "there is not one action")
    demand(actions and references_of(actions[0]["result"]), "the action has no result")


def check_codecheck(folder):
    text = (folder / "codecheck.yml").read_bytes().decode("utf-8")
    demand(text.startswith("%YAML 1.1\n---\n"), "codecheck.yml is no explicit document")
    content = yaml.safe_load(text)
    follows(CODECHECK, content, "codecheck.yml")
    for entry in content["manifest"]:
        demand((folder / entry["file"]).is_file(), f"codecheck.yml: {entry['file']} is not there")


if __name__ == "__main__":
    check_crate(pathlib.Path(sys.argv[1]))
    check_codecheck(pathlib.Path(sys.argv[1]))
    for problem in problems:
        print(problem, file=sys.stderr)
    sys.exit(1 if problems else 0)
