"""Snippets: the files, what can be computed from them, and what each can be joined with."""
