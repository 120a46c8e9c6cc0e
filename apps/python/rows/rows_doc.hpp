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
#define CONTACT_PIN_DOC                                                        \
  "tilt: slope of a pin's axis in its hole, (..., 3).\n"                       \
  "place: of the reaction along a pin, m from its middle, (...), instead of\n" \
  "    a tilt, which is then found.\n"
#define CONTACT_NUMBERS_DOC                            \
  "out: an array for the result, which is returned.\n" \
  "threads: how many share the rows."
