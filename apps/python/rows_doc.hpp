#pragma once

/// Docstrings of arguments that many functions have.
#define CONTACT_ROWS_DOC                                                      \
  "fields: names of the quantities that are wanted, as \"friction_moment\": " \
  "they\n"                                                                    \
  "    alone are kept, and returned as a dict of arrays.\n"                   \
  "out: arrays for them by their names, as a dict, which is returned.\n"      \
  "threads: how many share the rows.\n"
#define CONTACT_NUMBERS_DOC                            \
  "out: an array for the result, which is returned.\n" \
  "threads: how many share the rows."
