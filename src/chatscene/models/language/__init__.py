"""Language models as a plug-in: one question, one validated answer."""
