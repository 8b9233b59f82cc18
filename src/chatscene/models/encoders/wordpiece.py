"""BERT's tokenizer for one encoder: lower case, no accents, words into pieces of a fixed vocabulary.

Source: J. Devlin et al., "BERT", 2018; Y. Wu et al., "Google's Neural Machine Translation System", 2016 (WordPiece).
The vocabulary beside this file is that of BERT base uncased (see NOTICE).
"""

from __future__ import annotations

import unicodedata
from collections.abc import Iterator
from functools import lru_cache
from pathlib import Path

VOCABULARY = Path(__file__).with_name("vocab.txt")
LONGEST_WORD = 100  # characters; longer ones are unknown, as in the reference
_IDEOGRAPHS = ((0x4E00, 0x9FFF), (0x3400, 0x4DBF), (0xF900, 0xFAFF), (0x20000, 0x2FA1F))
_CLS, _SEP, _UNKNOWN = "[CLS]", "[SEP]", "[UNK]"


@lru_cache(maxsize=1)
def _vocabulary() -> dict[str, int]:
    return {piece: i for i, piece in enumerate(VOCABULARY.read_text(encoding="utf-8").splitlines())}


def tokenize(text: str, longest: int) -> list[int]:
    """The ids of a text's pieces, between the start and end marks, cut to `longest`."""
    vocabulary = _vocabulary()
    pieces = [vocabulary[piece] for word in _words(text) for piece in _pieces(word, vocabulary)]
    return [vocabulary[_CLS], *pieces[: longest - 2], vocabulary[_SEP]]


def _words(text: str) -> Iterator[str]:
    """Lower-case words without accents; each punctuation mark and CJK character is a word."""
    word = ""
    for char in unicodedata.normalize("NFD", "".join(_cleaned(text)).lower()):
        kind = unicodedata.category(char)
        if kind == "Mn":
            continue
        alone = _is_punctuation(char, kind) or any(low <= ord(char) <= high for low, high in _IDEOGRAPHS)
        if word and (alone or char.isspace()):
            yield word
            word = ""
        if alone:
            yield char
        elif not char.isspace():
            word += char
    if word:
        yield word


def _cleaned(text: str) -> Iterator[str]:
    for char in text:
        if char in "\t\n\r":
            yield " "
        elif char != "\ufffd" and unicodedata.category(char) not in ("Cc", "Cf", "Co", "Cs"):
            yield char


def _is_punctuation(char: str, kind: str) -> bool:
    # All ASCII symbols count, even those that Unicode does not call punctuation.
    return kind.startswith("P") or (ord(char) < 128 and char.isprintable() and not char.isalnum() and char != " ")


def _pieces(word: str, vocabulary: dict[str, int]) -> list[str]:
    """The longest known piece from the left, again and again; one unknown mark if that fails."""
    if len(word) > LONGEST_WORD:
        return [_UNKNOWN]
    pieces: list[str] = []
    start = 0
    while start < len(word):
        mark = "##" if start else ""
        end = next((e for e in range(len(word), start, -1) if mark + word[start:e] in vocabulary), None)
        if end is None:
            return [_UNKNOWN]
        pieces.append(mark + word[start:end])
        start = end
    return pieces
