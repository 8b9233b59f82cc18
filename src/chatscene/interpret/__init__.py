"""From what was read to the triple of snippets that says it, or a refusal with reasons (paper, section 3.3)."""
