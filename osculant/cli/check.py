"""The command ``osculant check``."""

from __future__ import annotations

from typing import Annotated

import typer

from osculant.cli.grammar import UsageError
from osculant.cli.options import AsJson
from osculant.cli.output import print_json

File = Annotated[
    str,
    typer.Argument(
        metavar="FILE",
        help='A certificate file, such as "osculant germ ... --certificate --json" prints.',
    ),
]


def check(file: File, as_json: AsJson = False) -> None:
    """Check a certificate file independently of what wrote it, and print what it proves.

    JSON: "accepted", true; "proved", the sentences.
    """
    from osculant.certificates.check_text import RejectedError
    from osculant.certificates.checker import check as checked

    try:
        proved = checked(file)
    except RejectedError as error:
        raise UsageError(f"{file} is refused: {error}.") from None
    except OSError as error:
        raise UsageError(f"{file} cannot be read: {error.strerror or error}.") from None
    if as_json:
        print_json({"accepted": True, "proved": list(proved)})
        return
    for sentence in proved:
        print(sentence)
