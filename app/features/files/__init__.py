"""The Share tab: files, links, and what is taken home."""
