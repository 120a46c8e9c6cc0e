/* SPDX-License-Identifier: MIT */
/* Status, messages and version, shared by the whole C interface. */
#ifndef LIBCONTACT_C_STATUS_H
#define LIBCONTACT_C_STATUS_H

/* NOLINTBEGIN(readability-identifier-naming,modernize-*) */
#ifdef __cplusplus
extern "C" {
#endif

/* Versions of these headers and of the library. Until 1.0 they must be the same
 * up to the last number. */
#define CONTACT_VERSION "0.3.0"
const char* contact_version(void);

typedef enum contact_status {
  CONTACT_OK = 0,
  CONTACT_OUT_OF_RANGE = 1,  /* no value there: the results are NaN */
  CONTACT_NOT_CONVERGED = 2, /* not to the tolerance: the best found */
  CONTACT_BAD_INPUT = 3,     /* a file, a key, a number or a call is refused */
  CONTACT_RUN_FAILED = 4,    /* a motion cannot go on */
  CONTACT_FAILURE = 5,       /* no memory, or an error of the library */
  CONTACT_OUT_OF_SEAT = 6    /* no pressure on the seat carries the load: NaN */
} contact_status;

/* Message of the calling thread's last call that did not return CONTACT_OK; ""
 * before there was one. Valid until the thread's next call. */
const char* contact_last_message(void);

/* Stores a message for the calling thread's last call, truncated to 2047 bytes,
 * and returns the status: for libraries built on this one, such as runs. */
contact_status contact_report(contact_status status, const char* message);

/* A key of a file that is given another value, as "geometry.radius_mm" = "25";
 * of a joint of a case as docs/reference/case_file.md says. */
typedef struct contact_setting {
  const char* key;
  const char* value;
} contact_setting;

#ifdef __cplusplus
}
#endif
/* NOLINTEND(readability-identifier-naming,modernize-*) */

#endif
