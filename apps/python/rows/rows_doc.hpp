#pragma once

/// Docstrings of arguments that many functions have.
#define CONTACT_ROWS_DOC                                                     \
  "fields: name or names of quantities, such as \"friction_moment\": only\n" \
  "    these are kept, and returned as a dict of arrays.\n"                  \
  "out: a dict of arrays for the quantities, which is returned.\n"           \
  "threads: number of threads that share the rows.\n"
#define CONTACT_SEAT_DOC                                                      \
  "from_seat: for a joint with a [seat]: rotation from the axes of the\n"     \
  "    body with the seat to the axes of the vectors, (..., 3, 3); None if\n" \
  "    they coincide.\n"
#define CONTACT_PIN_DOC                                                        \
  "tilt: slope of a pin's axis in its hole, (..., 3).\n"                       \
  "place: of the reaction along a pin, m from its middle, (...), instead of\n" \
  "    a tilt, which is then computed.\n"
#define CONTACT_NUMBERS_DOC                            \
  "out: an array for the result, which is returned.\n" \
  "threads: number of threads that share the rows."
