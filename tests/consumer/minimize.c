/* SPDX-License-Identifier: MIT */
/**
 * \file
 * Minimizes bending of a generated cage through the installed contract, and prints the versions and the run's levels.
 */
#include <stdio.h>
#include <string.h>
#include <umbilic/api.h>

static int failed(void) {
  char message[256];
  umbilic_copy_message(message, sizeof message);
  fprintf(stderr, "%s\n", message);
  return 1;
}

int main(void) {
  const char problem[] =
      "{\"umbilic\": \"problem\", \"version\": 1, \"cage\": {\"generator\": \"two-3\"},"
      " \"terms\": {\"bending\": 1}, \"options\": {\"levels\": [0, 1]}}";
  umbilic_run* run;
  umbilic_text levels;
  int32_t done = 0;
  if (umbilic_run_create(problem, strlen(problem), NULL, 0, &run) != UMBILIC_OK) return failed();
  while (!done) {
    if (umbilic_run_step(run, 10, &done) != UMBILIC_OK) return failed();
  }
  if (umbilic_run_part(run, UMBILIC_PART_LEVELS, &levels) != UMBILIC_OK) return failed();
  printf("%d.%d.%d %s\n", UMBILIC_VERSION_MAJOR, UMBILIC_VERSION_MINOR, UMBILIC_VERSION_PATCH, umbilic_version());
  fwrite(levels.data, 1, levels.length, stdout);
  umbilic_run_destroy(run);
  return 0;
}
