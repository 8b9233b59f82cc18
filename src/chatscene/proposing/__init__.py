"""Growing the library with a language model: drafts, trials behind both walls, and a queue that a person empties."""
