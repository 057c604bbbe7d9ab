"""The forms of all reports: sections of text, tables and figures, and a progress bar."""
