"""The nouns everything shares: frozen, typed, without input or output of their own."""
