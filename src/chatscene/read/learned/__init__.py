"""One learned model from a text to ranked situations."""
