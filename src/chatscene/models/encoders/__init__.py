"""Encoders: a sentence becomes a vector (paper, section 3.3)."""
