#pragma once

/// Docstrings of arguments that many functions have.
#define CONTACT_ROWS_DOC                                                      \
  "fields: name or names of the quantities that are wanted, as\n"             \
  "    \"friction_moment\": they alone are kept, and returned as a dict of\n" \
  "    arrays.\n"                                                             \
  "out: arrays for them by their names, as a dict, which is returned.\n"      \
  "threads: how many share the rows.\n"
#define CONTACT_NUMBERS_DOC                            \
  "out: an array for the result, which is returned.\n" \
  "threads: how many share the rows."
