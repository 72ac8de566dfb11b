"""Stands in for Matplotlib: keeps what the examples of a page plot and draws nothing."""
