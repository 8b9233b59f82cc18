"""Models of others behind Protocols: language models and encoders of sentences."""
