"""The vehicle under test."""
