#pragma once

/// Docstrings of arguments that many functions have.
#define CONTACT_ROWS_DOC                                                      \
  "fields: name or names of the quantities that are wanted, as\n"             \
  "    \"friction_moment\": they alone are kept, and returned as a dict of\n" \
  "    arrays.\n"                                                             \
  "out: arrays for them by their names, as a dict, which is returned.\n"      \
  "threads: how many share the rows.\n"
#define CONTACT_SEAT_DOC                                                       \
  "from_seat: of a joint with a [seat]: rotation from the axes of the body\n"  \
  "    that has it to those of the vectors, (..., 3, 3); None: they are the\n" \
  "    same.\n"
#define CONTACT_NUMBERS_DOC                            \
  "out: an array for the result, which is returned.\n" \
  "threads: how many share the rows."
