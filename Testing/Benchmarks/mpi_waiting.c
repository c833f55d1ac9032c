/* SPDX-FileCopyrightText: Littoral contributors */
/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Processor time that a thread spends in waiting for other ranks, apart from its work: MPI waits busily. Preloaded, it
 * stands between a program and MPI. Before each call that can wait, all that it has to wait for is waited for: a
 * message that has come, or ranks that have all come; what the call then takes is the moving of data, which is work.
 * Waits for requests count whole. A send counts as work, also where it waits for who receives.
 */
#define _POSIX_C_SOURCE 200809L

#include <mpi.h>
#include <time.h>

static double Waited = 0.0;

static double ProcessorTime(void)
{
  struct timespec now;
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* What the thread has waited so far [s]. */
double SecondsWaited(void)
{
  return Waited;
}

#define WAITING(call)                                                                                                  \
  const double begin = ProcessorTime();                                                                                \
  const int answer = (call);                                                                                           \
  Waited += ProcessorTime() - begin

#define COUNTS(NAME, PARAMETERS, ARGUMENTS)                                                                            \
  int MPI_##NAME PARAMETERS                                                                                            \
  {                                                                                                                    \
    WAITING(PMPI_##NAME ARGUMENTS);                                                                                    \
    return answer;                                                                                                     \
  }

#define COUNTS_BEFORE(NAME, PARAMETERS, ARGUMENTS)                                                                     \
  int MPI_##NAME PARAMETERS                                                                                            \
  {                                                                                                                    \
    WAITING(PMPI_Barrier(comm));                                                                                       \
    return answer == MPI_SUCCESS ? PMPI_##NAME ARGUMENTS : answer;                                                     \
  }

COUNTS(Barrier, (MPI_Comm comm), (comm))
COUNTS(Probe, (int source, int tag, MPI_Comm comm, MPI_Status* status), (source, tag, comm, status))
COUNTS(Wait, (MPI_Request * request, MPI_Status* status), (request, status))
COUNTS(Waitall, (int count, MPI_Request requests[], MPI_Status statuses[]), (count, requests, statuses))
COUNTS(Waitany, (int count, MPI_Request requests[], int* index, MPI_Status* status), (count, requests, index, status))
COUNTS(Waitsome, (int count, MPI_Request requests[], int* done, int indices[], MPI_Status statuses[]),
  (count, requests, done, indices, statuses))

/* Calls with counts of int, and from MPI 4 on those with larger ones. */
#define CALLS(SUFFIX, Count, Place)                                                                                    \
  COUNTS_BEFORE(Bcast##SUFFIX, (void* buffer, Count count, MPI_Datatype type, int root, MPI_Comm comm),                \
    (buffer, count, type, root, comm))                                                                                 \
  COUNTS_BEFORE(Reduce##SUFFIX,                                                                                        \
    (const void* sent, void* received, Count count, MPI_Datatype type, MPI_Op op, int root, MPI_Comm comm),            \
    (sent, received, count, type, op, root, comm))                                                                     \
  COUNTS_BEFORE(Allreduce##SUFFIX,                                                                                     \
    (const void* sent, void* received, Count count, MPI_Datatype type, MPI_Op op, MPI_Comm comm),                      \
    (sent, received, count, type, op, comm))                                                                           \
  COUNTS_BEFORE(Gather##SUFFIX,                                                                                        \
    (const void* sent, Count count, MPI_Datatype type, void* received, Count each, MPI_Datatype as, int root,          \
      MPI_Comm comm),                                                                                                  \
    (sent, count, type, received, each, as, root, comm))                                                               \
  COUNTS_BEFORE(Gatherv##SUFFIX,                                                                                       \
    (const void* sent, Count count, MPI_Datatype type, void* received, const Count counts[], const Place places[],     \
      MPI_Datatype as, int root, MPI_Comm comm),                                                                       \
    (sent, count, type, received, counts, places, as, root, comm))                                                     \
  COUNTS_BEFORE(Scatter##SUFFIX,                                                                                       \
    (const void* sent, Count count, MPI_Datatype type, void* received, Count each, MPI_Datatype as, int root,          \
      MPI_Comm comm),                                                                                                  \
    (sent, count, type, received, each, as, root, comm))                                                               \
  COUNTS_BEFORE(Scatterv##SUFFIX,                                                                                      \
    (const void* sent, const Count counts[], const Place places[], MPI_Datatype type, void* received, Count count,     \
      MPI_Datatype as, int root, MPI_Comm comm),                                                                       \
    (sent, counts, places, type, received, count, as, root, comm))                                                     \
  COUNTS_BEFORE(Allgather##SUFFIX,                                                                                     \
    (const void* sent, Count count, MPI_Datatype type, void* received, Count each, MPI_Datatype as, MPI_Comm comm),    \
    (sent, count, type, received, each, as, comm))                                                                     \
  COUNTS_BEFORE(Allgatherv##SUFFIX,                                                                                    \
    (const void* sent, Count count, MPI_Datatype type, void* received, const Count counts[], const Place places[],     \
      MPI_Datatype as, MPI_Comm comm),                                                                                 \
    (sent, count, type, received, counts, places, as, comm))                                                           \
  COUNTS_BEFORE(Alltoall##SUFFIX,                                                                                      \
    (const void* sent, Count count, MPI_Datatype type, void* received, Count each, MPI_Datatype as, MPI_Comm comm),    \
    (sent, count, type, received, each, as, comm))                                                                     \
                                                                                                                       \
  int MPI_Recv##SUFFIX(                                                                                                \
    void* buffer, Count count, MPI_Datatype type, int source, int tag, MPI_Comm comm, MPI_Status* status)              \
  {                                                                                                                    \
    MPI_Status come;                                                                                                   \
    WAITING(PMPI_Probe(source, tag, comm, &come));                                                                     \
    return answer == MPI_SUCCESS ? PMPI_Recv##SUFFIX(buffer, count, type, come.MPI_SOURCE, come.MPI_TAG, comm, status) \
                                 : answer;                                                                             \
  }

CALLS(, int, int)
#if MPI_VERSION >= 4
CALLS(_c, MPI_Count, MPI_Aint)
#endif
