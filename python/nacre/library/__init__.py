"""A library of paints: recipes and sweeps become a folder of records with one catalogue.

A plan (docs/library.md) names base recipes and the numbers that are to vary; each paint of it
becomes a record with its recipe, its readings and whatever else the plan asks for, computed on one
machine or many. ``nacre-library`` is the same on the command line.

>>> from nacre.library import Plan, sampling
>>> sampling.grid([sampling.Range(80, 120, steps=3)])
[(80.0,), (100.0,), (120.0,)]
"""

from .catalogue import Catalogue
from .find import Match, find
from .record import Record
from .settings import Settings
from .sweep import Plan

__all__ = ["Catalogue", "Match", "Plan", "Record", "Settings", "find"]
