"""A library that grows: snippets checked, proposed and reviewed, and the reader fitted to it again."""
