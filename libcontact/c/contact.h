/* SPDX-License-Identifier: MIT */
/* Hinge friction from C: joints under a reaction.
 *
 * SI units and radians. Vectors are in any frame, the same for all of a call;
 * of a joint with a [seat] in the axes of the body that has it. Names, formulas
 * and accuracy follow the C++ library (docs/reference/notation.md,
 * docs/explanation/joint.md); numbers are bit-identical.
 *
 * A function returns a contact_status. Where it is not CONTACT_OK
 * contact_last_message() says why in one line; results are NaN, or for
 * CONTACT_NOT_CONVERGED the best that was found. A null pointer where none is
 * allowed is refused (CONTACT_BAD_INPUT). A refused call leaves NULL in the
 * place of the joint that it does not make, and its status and NaN in other
 * results. Joints are given back by their _free(), which takes NULL too.
 *
 * Threads: a joint may be used by many at once. No function writes files,
 * prints or touches signals. Runs of hinge-separation are a library of their
 * own: libcontact/c/run.h. */
#ifndef LIBCONTACT_C_CONTACT_H
#define LIBCONTACT_C_CONTACT_H

#include "libcontact/c/ends.h"
#include "libcontact/c/joint.h"
#include "libcontact/c/mechanism.h"
#include "libcontact/c/moments.h"
#include "libcontact/c/play.h"
#include "libcontact/c/quantity.h"
#include "libcontact/c/slip.h"
#include "libcontact/c/status.h"
#include "libcontact/c/step.h"

#endif
