"""Attacks on the program from outside (fuzz/attack.py)."""
