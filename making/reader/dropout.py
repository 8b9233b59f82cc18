"""Dropout from a pool of masks that is drawn once: on a processor, drawing a new mask takes longer than a layer."""

from __future__ import annotations

import torch
from torch import Tensor, nn

POOL = 1 << 24
"""Numbers of the pool; a mask is a stretch of it that begins anywhere."""


class Dropout(nn.Module):
    """As `torch.nn.Dropout`; masks are stretches of one pool.

    Args:
        p: The share that becomes zero.
    """

    _pools: dict[float, Tensor] = {}  # noqa: RUF012 - one per share, of which there is one

    def __init__(self, p: float) -> None:
        super().__init__()
        self.p = p

    def forward(self, x: Tensor) -> Tensor:
        """The same, with some numbers zero and the others larger in turn, in training."""
        if not self.training or self.p == 0.0:
            return x
        if self.p not in self._pools:
            kept = torch.rand(POOL, generator=torch.Generator().manual_seed(0)) >= self.p
            self._pools[self.p] = kept.to(torch.bfloat16) / (1.0 - self.p)
        n = x.numel()
        at = int(torch.randint(POOL - n + 1, (1,)))
        return x * self._pools[self.p][at : at + n].view(x.shape).to(x.dtype)
