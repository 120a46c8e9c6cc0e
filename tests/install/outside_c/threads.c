/* Both shared libraries by dlopen() and from two threads, which share a joint:
 * both find the same, and each has the message of its own last failure.
 *   threads LIBRARY RUNS_LIBRARY JOINT.toml CASE.toml */
#include <dlfcn.h>
#include <libcontact/c/contact.h>
#include <libcontact/c/run.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>

enum { rows = 500 };

/* The functions by their names, of the types that the header gives them. */
#define JOINT_FUNCTIONS(X)    \
  X(contact_last_message)     \
  X(contact_joint_read)       \
  X(contact_joint_free)       \
  X(contact_joint_solve_rows) \
  X(contact_joint_patch)
#define RUN_FUNCTIONS(X)   \
  X(contact_run_open)      \
  X(contact_run_free)      \
  X(contact_run_advance)   \
  X(contact_run_row_count) \
  X(contact_run_row)       \
  X(contact_run_column_count)
#define DECLARE(name) __extension__ static __typeof__(&name) p_##name;
JOINT_FUNCTIONS(DECLARE)
RUN_FUNCTIONS(DECLARE)

static int load(const char* file, const char* runs_file) {
  void* library = dlopen(file, RTLD_NOW | RTLD_LOCAL);
  void* runs_library = dlopen(runs_file, RTLD_NOW | RTLD_LOCAL);
  if (!library || !runs_library) return 0;
    /* POSIX on dlsym(): an object pointer that is copied. */
#define LOAD_FROM(library, name)                \
  {                                             \
    void* found = dlsym(library, #name);        \
    memcpy(&p_##name, &found, sizeof p_##name); \
    if (!found) return 0;                       \
  }
#define LOAD(name) LOAD_FROM(library, name)
#define LOAD_RUNS(name) LOAD_FROM(runs_library, name)
  JOINT_FUNCTIONS(LOAD)
  RUN_FUNCTIONS(LOAD_RUNS)
  return 1;
}

struct task {
  const contact_joint* joint;
  const char* case_file;
  double bad_force; /* makes the message of this thread */
  contact_solution solutions[rows];
  double last_row[200];
  char message[200];
  int good;
};

static int solve(struct task* t) {
  static const double pi = 3.14159265358979;
  double reaction[rows][3], rate[rows][3];
  contact_slips slips = {0};
  for (int i = 0; i < rows; ++i) {
    for (int k = 0; k < 3; ++k) {
      reaction[i][k] = 100. * (i % 17 + 1) * (k == 2 ? 1 : 0.1 * k);
      rate[i][k] = (i * 7 + k * 5) % 11 - pi;
    }
  }
  slips.count = rows;
  slips.reaction = reaction[0];
  slips.reaction_stride = sizeof reaction[0];
  slips.angular_velocity = rate[0];
  slips.angular_velocity_stride = sizeof rate[0];
  slips.warm = 1;
  return p_contact_joint_solve_rows(t->joint, &slips, t->solutions,
                                    sizeof t->solutions[0]) == CONTACT_OK;
}

static int turn(struct task* t) {
  contact_run* run;
  size_t count, columns;
  if (p_contact_run_open(t->case_file, NULL, 0, &run)) return 0;
  if (p_contact_run_advance(run, 1)) return 0;
  count = p_contact_run_row_count(run);
  columns = p_contact_run_column_count(run);
  if (count < 2 || columns > 200) return 0;
  memcpy(t->last_row, p_contact_run_row(run, count - 1),
         columns * sizeof(double));
  p_contact_run_free(run);
  return 1;
}

static void* work(void* task) {
  struct task* t = task;
  contact_patch patch;
  t->good = t->good && p_contact_last_message()[0] == '\0' &&
            p_contact_joint_patch(t->joint, t->bad_force, &patch) ==
                CONTACT_OUT_OF_RANGE &&
            solve(t) && turn(t);
  strncpy(t->message, p_contact_last_message(), sizeof t->message - 1);
  return NULL;
}

int main(int count, char** arguments) {
  static struct task tasks[2];
  pthread_t threads[2];
  contact_joint* joint;
  if (count != 5 || !load(arguments[1], arguments[2])) {
    fprintf(stderr, "%s\n", dlerror());
    return 1;
  }
  if (p_contact_joint_read(arguments[3], NULL, 0, &joint)) return 1;
  for (int i = 0; i < 2; ++i) {
    tasks[i].joint = joint;
    tasks[i].case_file = arguments[4];
    tasks[i].bad_force = -1 - i;
    tasks[i].good = 1;
    if (pthread_create(&threads[i], NULL, work, &tasks[i])) return 1;
  }
  for (int i = 0; i < 2; ++i) pthread_join(threads[i], NULL);
  p_contact_joint_free(joint);
  printf("%s\n%s\n", tasks[0].message, tasks[1].message);
  return !(
      tasks[0].good && tasks[1].good &&
      !memcmp(tasks[0].solutions, tasks[1].solutions,
              sizeof tasks[0].solutions) &&
      !memcmp(tasks[0].last_row, tasks[1].last_row, sizeof tasks[0].last_row) &&
      tasks[0].last_row[0] == 1 &&
      !strcmp(tasks[0].message,
              "contact_joint_patch: normal_force = -1 must be in the "
              "range of the laws") &&
      !strcmp(tasks[1].message,
              "contact_joint_patch: normal_force = -2 must be in the "
              "range of the laws"));
}
