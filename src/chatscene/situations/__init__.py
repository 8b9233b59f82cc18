"""Situations as files: read with the line of each fault, written, addressed by path, described by a JSON schema."""
