"""Train the learned reader.

    python -m making.reader.fit --told benchmarks/texts/filled.jsonl --told benchmarks/texts/told-first.jsonl \
        --drawn drawn.jsonl --epochs 8 --seed 0 --out FOLDER

Writes `reader.npz` and `reader.json`, which the reader loads, and `reader.pt`, from which the next call goes on if it
was stopped, in FOLDER. The same comes out again with as many threads. Needs the extra ``train``.
"""

from __future__ import annotations

import random
import time
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import click
import torch
from torch import Tensor
from torch.nn.attention import SDPBackend, sdpa_kernel

from chatscene.read.learned.grammar import BEGUN, Grammar, Token, grammar
from chatscene.read.learned.weights import NAME, Weights, save
from making.reader.export import exported
from making.reader.network import Network
from making.reader.texts import Example, in_our_words, of_edits, of_told, situations_in, told_in
from making.reader.trust import calibrate

BATCH, ALIKE = 32, 16  # texts of a step; steps whose texts are sorted by length together
RATE, DECODER_RATE = 1e-4, 8e-4  # of AdamW
WARM_UP, LEAST = 0.05, 0.02  # share of the steps, and of the rate at the end
FROZEN = 0  # lower layers of the encoder that are not trained
SHOWN = 50  # steps after which the loss is told
MARKING = 0.1  # weight of a piece that is marked wrongly
NEVER = -1e9


@dataclass(frozen=True)
class Tables:
    """The grammar as arrays.

    Attributes:
        places: Each place's number.
        follow: (places, tokens) whether a token may come after one at a place.
        copies: (places, kinds) whether an amount of a kind may.
        kinds: Of amounts.
    """

    places: dict[str, int]
    follow: Tensor
    copies: Tensor
    kinds: tuple[type[Any], ...]


def batches(lengths: Sequence[int], rng: random.Random) -> list[list[int]]:
    """Rows in random order, in batches whose texts are of similar length."""
    order = rng.sample(range(len(lengths)), len(lengths))
    span = BATCH * ALIKE
    chunks = [sorted(order[i : i + span], key=lambda row: lengths[row]) for i in range(0, len(order), span)]
    batches = [chunk[i : i + BATCH] for chunk in chunks for i in range(0, len(chunk), BATCH)]
    rng.shuffle(batches)
    return batches


def tables(made: Grammar) -> Tables:
    """The grammar as arrays."""
    names = tuple(made.follow)
    follow, kinds = torch.zeros(len(names), len(made.tokens), dtype=torch.bool), made.kinds
    copies = torch.zeros(len(names), len(kinds), dtype=torch.bool)
    for i, name in enumerate(names):
        for there in made.follow[name]:
            follow[i, list(made.of[there])] = True
            for kind in made.amounts.get(there, ()):
                copies[i, kinds.index(kind)] = True
    return Tables({name: i for i, name in enumerate(names)}, follow, copies, kinds)


class Learning:
    """A network and the texts that it learns from."""

    def __init__(self, examples: Sequence[Example], seed: int, began: Path | None, frozen: int) -> None:
        torch.manual_seed(seed)
        self.grammar, self.tables, self.examples = grammar(), tables(grammar()), examples
        self.network = Network(tokens=len(self.grammar.tokens), places=len(self.tables.places), frozen=frozen)
        if began is not None:
            self.network.begin_with(
                _as_now(torch.load(began, weights_only=True), self.grammar.tokens, tuple(self.tables.places))
            )
        texts = {one.read.text: one.read.pieces for one in examples}
        lower = dict(zip(texts, self.network.encoder.lower(list(texts.values())), strict=True))
        self.lower = [lower[one.read.text] for one in examples]

    def loss(self, rows: Sequence[int]) -> Tensor:
        """How unlikely what the texts tell is, in nats per text."""
        several = [self.examples[i] for i in rows]
        states, padding = self.network.states([self.lower[i] for i in rows])
        share, forms, kinds = spans(several, states.shape[1], self.tables.kinds)
        amounts = self.network.amounts(states, share, forms)
        given = Written(several, self.grammar, self.tables)
        copied = torch.zeros(*given.tokens.shape, amounts.shape[-1], dtype=amounts.dtype)
        n, t = given.copied.nonzero(as_tuple=True)
        copied[n, t] = amounts[n, given.which[n, t]] + self.network.copied.to(amounts.dtype)
        at = torch.arange(given.tokens.shape[1])[None, :]
        x = self.network.begun(given.tokens, given.places, at, copied)
        mask = torch.zeros(padding.shape).masked_fill(padding, NEVER)[:, None, None]
        memory = self.network.memory(states)
        for layer in self.network.layers:
            x, _ = layer(x, layer.of_text(memory), mask)
        odds = self.network.odds(x, amounts)
        marked = self.network.marks(x, self.network.marked(states))
        may_copy = self.tables.copies[given.places][..., kinds].diagonal(dim1=0, dim2=2).permute(2, 0, 1)
        allowed = torch.cat([self.tables.follow[given.places] & ~given.barred[:, None], may_copy], -1)
        z = odds.masked_fill(~allowed, NEVER)
        losses = torch.nn.functional.cross_entropy(z.transpose(1, 2), given.next, reduction="none")
        known = given.learned * allowed.gather(2, given.next[..., None])[..., 0]
        words, are_known = words_of(several, *marked.shape[1:])
        missed = torch.nn.functional.binary_cross_entropy_with_logits(marked, words, reduction="none")
        missed = (missed * are_known[..., None] * ~padding[:, None]).sum()
        return ((losses * known).sum() + MARKING * missed) / len(rows)


def _as_now(trained: Mapping[str, Any], tokens: Sequence[Token], places: Sequence[str]) -> Mapping[str, Tensor]:
    """The weights of a network, with rows for the tokens and places of now; what is new begins as the mean."""
    network = dict(trained["network"])
    rows = {"token.weight": ("tokens", tokens), "out.weight": ("tokens", tokens), "out.bias": ("tokens", tokens),
            "place.weight": ("places", places)}  # fmt: skip
    for name, (kind, now) in rows.items():
        had = {each: i for i, each in enumerate(trained.get(kind, now))}
        old = network[name]
        network[name] = torch.stack([old[had[each]] if each in had else old.mean(0) for each in now])
    return network


class Written:
    """What is written of some texts, as arrays: (texts, steps) each, but for what is barred, (texts, tokens)."""

    def __init__(self, several: Sequence[Example], made: Grammar, given: Tables) -> None:
        shape = len(several), max(len(one.steps) for one in several)
        self.tokens, self.places, self.next, self.which = (torch.zeros(shape, dtype=torch.long) for _ in range(4))
        self.copied, self.learned = torch.zeros(shape, dtype=torch.bool), torch.zeros(shape)
        self.barred = torch.zeros(len(several), len(made.tokens), dtype=torch.bool)
        number = made.number
        for i, one in enumerate(several):
            self.barred[i, list(one.barred)] = True
            before, token, which = BEGUN, 0, -1
            for t, (step, copy) in enumerate(zip(one.steps, one.copied, strict=True)):
                self.places[i, t], self.tokens[i, t] = given.places[before], token
                self.copied[i, t], self.which[i, t] = which >= 0, max(which, 0)
                is_copied = step.token is None
                token = 0 if step.token is None else number[step.token]
                which = copy if is_copied else -1
                self.next[i, t] = len(made.tokens) + copy if is_copied else token
                self.learned[i, t], before = 1.0, step.place
            self.places[i, len(one.steps) :] = given.places[BEGUN]


def spans(several: Sequence[Example], pieces: int, kinds: Sequence[type[Any]]) -> tuple[Tensor, Tensor, Tensor]:
    """Of each amount of each text the share of each piece, its form, and its kind; the last where it has none."""
    most = max(1, *(len(one.read.amounts) for one in several))
    share = torch.zeros(len(several), most, pieces)
    forms, which = (torch.zeros(len(several), most, dtype=torch.long) for _ in range(2))
    which += len(kinds) - 1
    for i, one in enumerate(several):
        for k, (found, (low, high)) in enumerate(zip(one.read.amounts, one.read.spans, strict=True)):
            share[i, k, low:high] = 1 / (high - low)
            forms[i, k], which[i, k] = int(found.form), kinds.index(type(found.amount))
    return share, forms, which


def words_of(several: Sequence[Example], steps: int, pieces: int) -> tuple[Tensor, Tensor]:
    """(N, steps, pieces) whether a piece says the token that went in at a step; (N, steps) whether that is known."""
    says, known = torch.zeros(len(several), steps, pieces), torch.zeros(len(several), steps)
    for i, one in enumerate(several):
        for t, some in enumerate(one.words[: steps - 1]):
            if some:
                says[i, t + 1, list(some)], known[i, t + 1] = 1.0, 1.0
    return says, known


def fit(learning: Learning, *, epochs: int, seed: int, out: Path, minutes: float, half: bool = False) -> None:
    """Train, and keep the network after each epoch."""
    network, rng = learning.network, random.Random(seed)
    trained = [p for p in network.encoder.upper.parameters() if p.requires_grad]
    optimizer = torch.optim.AdamW(
        [{"params": trained, "lr": RATE}, {"params": network.decoder(), "lr": DECODER_RATE}], weight_decay=0.01
    )
    lengths = [len(one.read.pieces) for one in learning.examples]
    steps = epochs * -(-len(lengths) // BATCH)
    rates = torch.optim.lr_scheduler.LambdaLR(
        optimizer, lambda step: min(1.0, (step + 1) / (WARM_UP * steps)) * max(LEAST, 1.0 - step / steps)
    )
    kept, first = out / "reader.pt", 0
    if kept.exists():
        state = torch.load(kept, weights_only=True)
        network.load_state_dict(state["network"])
        optimizer.load_state_dict(state["optimizer"])
        rates.load_state_dict(state["rates"])
        torch.set_rng_state(state["random"])
        first = state["epoch"]
    network.train()
    begun = time.monotonic()
    for epoch in range(epochs):
        order, total = batches(lengths, rng), 0.0
        if epoch < first:
            continue
        for step, rows in enumerate(order, 1):
            with sdpa_kernel(SDPBackend.MATH), torch.autocast("cpu", dtype=torch.bfloat16, enabled=half):
                loss = learning.loss(rows)
            optimizer.zero_grad()
            loss.backward()
            torch.nn.utils.clip_grad_norm_(network.parameters(), 1.0)
            optimizer.step()
            rates.step()
            total += loss.item() * len(rows)
            if step % SHOWN == 0:
                click.echo(
                    f"  {step} of {len(order)}: loss {total / step / BATCH:.3f}, {time.monotonic() - begun:.0f} s"
                )
        click.echo(f"epoch {epoch + 1}: loss {total / len(lengths):.3f}, {time.monotonic() - begun:.0f} s")
        state = {
            "network": network.state_dict(),
            "optimizer": optimizer.state_dict(),
            "rates": rates.state_dict(),
            "random": torch.get_rng_state(),
            "epoch": epoch + 1,
            "tokens": learning.grammar.tokens,
            "places": tuple(learning.tables.places),
        }
        torch.save(state, kept.with_suffix(".new"))
        kept.with_suffix(".new").replace(kept)
        if time.monotonic() - begun > 60 * minutes:
            break


def written(learning: Learning, out: Path) -> None:
    """Write the file that the reader loads."""
    text, following = exported(learning.network)
    changes = learning.network.encoder.file_changes()
    tokens, places = learning.grammar.tokens, tuple(learning.tables.places)
    save(Weights(changes, text, following, tokens, places), out / NAME)


_FILE = click.Path(path_type=Path, exists=True, dir_okay=False)


@click.command()
@click.option("--told", type=_FILE, multiple=True, help="Texts with situations.")
@click.option("--drawn", type=_FILE, multiple=True, help="Situations that are told in our own words.")
@click.option("--edited", type=_FILE, multiple=True, help="Edits of situations, with what becomes of these.")
@click.option("--again", default=0, show_default=True, help="Situations of the texts told in our own words as well.")
@click.option("--sure", type=_FILE, multiple=True, help="Situations with texts, to fit how sure it may be.")
@click.option("--epochs", default=8, show_default=True)
@click.option("--minutes", default=1e9, help="After which no epoch begins.")
@click.option("--seed", default=0, show_default=True)
@click.option("--frozen", default=FROZEN, show_default=True)
@click.option("--half", is_flag=True, help="In bfloat16 where it may be: for processors that have it.")
@click.option("--threads", default=1, show_default=True)
@click.option("--began", type=_FILE, default=None, help="A network to begin with.")
@click.option("--out", type=click.Path(path_type=Path, file_okay=False), required=True)
def main(
    told: tuple[Path, ...], drawn: tuple[Path, ...], edited: tuple[Path, ...], again: int, sure: tuple[Path, ...],
    epochs: int, minutes: float, seed: int, frozen: int, half: bool, threads: int, began: Path | None, out: Path,
) -> None:  # fmt: skip
    """Train the learned reader."""
    torch.set_num_threads(threads)
    out.mkdir(parents=True, exist_ok=True)
    whole = [one for path in told for one in of_told(path)]
    edits = [one for path in edited for one in of_edits(path)]
    known = [said for path in told for _, _, said in told_in(path) if said is not None and said.others]
    drawn_ones = [one for path in drawn for one in situations_in(path)]
    ours = list(in_our_words([*drawn_ones, *random.Random(seed).sample(known, min(again, len(known)))]))
    click.echo(f"{len(whole)} texts of others, {len(edits)} edits, {len(ours)} texts of ours")
    learning = Learning([*whole, *edits, *ours], seed, began, frozen)
    fit(learning, epochs=epochs, seed=seed, out=out, minutes=minutes, half=half)
    written(learning, out)
    if sure:
        texts, right = calibrate(out / NAME, sure)
        click.echo(f"of {texts} texts to fit how sure it may be {right} are read rightly")


if __name__ == "__main__":
    main()
