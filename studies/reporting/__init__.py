"""What the studies share: the files of a report and how figures look."""
