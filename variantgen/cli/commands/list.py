"""``variantgen list``: what there is to choose from."""

from __future__ import annotations

import argparse
import json

from variantgen.cli.messages import say
from variantgen.cli.options import add_families, add_language

HELP = "list the problem families"
DESCRIPTION = "List the problem families of the catalogue and of your own folders."


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Options of the command."""
    add_language(parser)
    parser.add_argument("--json", action="store_true", help="print one JSON document")
    add_families(parser)


def run(arguments: argparse.Namespace) -> int:
    """Print names, titles and forms."""
    from variantgen.families.folders import family_folders
    from variantgen.families.load import family_names, load_family
    from variantgen.wording.language import load_language

    load_language(arguments.lang)
    folders = family_folders(arguments.families)
    families = [load_family(name, folders) for name in family_names(folders)]
    if arguments.json:
        rows = [{"family": f.name, "title": dict(f.titles), "forms": [n for n in f.forms if n]} for f in families]
        say(json.dumps(rows, ensure_ascii=False, indent=2))
        return 0
    width = max(len(family.name) for family in families)
    for family in families:
        forms = ", ".join(name for name in family.forms if name)
        say(f"{family.name:{width}}  {family.title(arguments.lang)}" + (f"  [{forms}]" if forms else ""))
    return 0
