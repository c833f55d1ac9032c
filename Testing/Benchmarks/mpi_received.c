/* SPDX-FileCopyrightText: Littoral contributors */
/* SPDX-License-Identifier: BSD-3-Clause */
/*
 * Bytes that a process receives of each other one. Preloaded, it stands between a program and MPI, whose calls it hands
 * on as they are. What MPI adds up on its way counts as received of each that takes part.
 */
#include <mpi.h>
#include <stdint.h>

enum
{
  MostRanks = 1024
};

static uint64_t Received[MostRanks];

/* What came so far of a rank of MPI_COMM_WORLD [bytes]. */
uint64_t BytesReceived(int rank)
{
  return rank >= 0 && rank < MostRanks ? Received[rank] : 0;
}

static uint64_t SizeOf(MPI_Datatype type)
{
  int size = 0;
  PMPI_Type_size(type, &size);
  return (uint64_t)size;
}

static int RankIn(MPI_Comm comm)
{
  int rank = 0;
  PMPI_Comm_rank(comm, &rank);
  return rank;
}

static int RanksIn(MPI_Comm comm)
{
  int ranks = 0;
  PMPI_Comm_size(comm, &ranks);
  return ranks;
}

/* Adds values that came of a rank of a group, if it is another one. */
static void Add(MPI_Comm comm, int source, uint64_t count, MPI_Datatype type)
{
  MPI_Group own;
  MPI_Group world;
  int rank = MPI_UNDEFINED;
  if (source == RankIn(comm))
  {
    return;
  }
  PMPI_Comm_group(comm, &own);
  PMPI_Comm_group(MPI_COMM_WORLD, &world);
  PMPI_Group_translate_ranks(own, 1, &source, world, &rank);
  PMPI_Group_free(&own);
  PMPI_Group_free(&world);
  if (rank >= 0 && rank < MostRanks)
  {
    Received[rank] += count * SizeOf(type);
  }
}

static void AddOfAll(MPI_Comm comm, uint64_t count, MPI_Datatype type)
{
  for (int rank = 0; rank < RanksIn(comm); ++rank)
  {
    Add(comm, rank, count, type);
  }
}

/* A message that has come. */
static void AddMessage(MPI_Comm comm, const MPI_Status* status)
{
  int bytes = 0;
  PMPI_Get_elements(status, MPI_BYTE, &bytes);
  Add(comm, status->MPI_SOURCE, (uint64_t)bytes, MPI_BYTE);
}

#define PASSES_ON(NAME, PARAMETERS, ARGUMENTS, COUNT)                                                                  \
  int MPI_##NAME PARAMETERS                                                                                            \
  {                                                                                                                    \
    const int answer = PMPI_##NAME ARGUMENTS;                                                                          \
    COUNT;                                                                                                             \
    return answer;                                                                                                     \
  }

/* Counts on the rank that all send to. */
#define AT_ROOT(count)                                                                                                 \
  if (RankIn(comm) == root)                                                                                            \
  (count)

/* Calls with counts of int, and from MPI 4 on those with larger ones. A receive without a wait counts as what fits. */
#define CALLS(SUFFIX, Count, Place)                                                                                    \
  PASSES_ON(Irecv##SUFFIX,                                                                                             \
    (void* buffer, Count count, MPI_Datatype type, int source, int tag, MPI_Comm comm, MPI_Request* request),          \
    (buffer, count, type, source, tag, comm, request), Add(comm, source, (uint64_t)count, type))                       \
  PASSES_ON(Bcast##SUFFIX, (void* buffer, Count count, MPI_Datatype type, int root, MPI_Comm comm),                    \
    (buffer, count, type, root, comm), Add(comm, root, (uint64_t)count, type))                                         \
  PASSES_ON(Reduce##SUFFIX,                                                                                            \
    (const void* sent, void* received, Count count, MPI_Datatype type, MPI_Op op, int root, MPI_Comm comm),            \
    (sent, received, count, type, op, root, comm), AT_ROOT(AddOfAll(comm, (uint64_t)count, type)))                     \
  PASSES_ON(Allreduce##SUFFIX,                                                                                         \
    (const void* sent, void* received, Count count, MPI_Datatype type, MPI_Op op, MPI_Comm comm),                      \
    (sent, received, count, type, op, comm), AddOfAll(comm, (uint64_t)count, type))                                    \
  PASSES_ON(Gather##SUFFIX,                                                                                            \
    (const void* sent, Count count, MPI_Datatype type, void* received, Count each, MPI_Datatype as, int root,          \
      MPI_Comm comm),                                                                                                  \
    (sent, count, type, received, each, as, root, comm), AT_ROOT(AddOfAll(comm, (uint64_t)each, as)))                  \
  PASSES_ON(Scatter##SUFFIX,                                                                                           \
    (const void* sent, Count count, MPI_Datatype type, void* received, Count each, MPI_Datatype as, int root,          \
      MPI_Comm comm),                                                                                                  \
    (sent, count, type, received, each, as, root, comm), Add(comm, root, (uint64_t)each, as))                          \
  PASSES_ON(Scatterv##SUFFIX,                                                                                          \
    (const void* sent, const Count counts[], const Place places[], MPI_Datatype type, void* received, Count count,     \
      MPI_Datatype as, int root, MPI_Comm comm),                                                                       \
    (sent, counts, places, type, received, count, as, root, comm), Add(comm, root, (uint64_t)count, as))               \
  PASSES_ON(Allgather##SUFFIX,                                                                                         \
    (const void* sent, Count count, MPI_Datatype type, void* received, Count each, MPI_Datatype as, MPI_Comm comm),    \
    (sent, count, type, received, each, as, comm), AddOfAll(comm, (uint64_t)each, as))                                 \
  PASSES_ON(Alltoall##SUFFIX,                                                                                          \
    (const void* sent, Count count, MPI_Datatype type, void* received, Count each, MPI_Datatype as, MPI_Comm comm),    \
    (sent, count, type, received, each, as, comm), AddOfAll(comm, (uint64_t)each, as))                                 \
                                                                                                                       \
  int MPI_Recv##SUFFIX(                                                                                                \
    void* buffer, Count count, MPI_Datatype type, int source, int tag, MPI_Comm comm, MPI_Status* status)              \
  {                                                                                                                    \
    MPI_Status come;                                                                                                   \
    const int answer = PMPI_Recv##SUFFIX(buffer, count, type, source, tag, comm, &come);                               \
    if (answer == MPI_SUCCESS)                                                                                         \
    {                                                                                                                  \
      AddMessage(comm, &come);                                                                                         \
    }                                                                                                                  \
    if (status != MPI_STATUS_IGNORE)                                                                                   \
    {                                                                                                                  \
      *status = come;                                                                                                  \
    }                                                                                                                  \
    return answer;                                                                                                     \
  }                                                                                                                    \
                                                                                                                       \
  int MPI_Gatherv##SUFFIX(const void* sent, Count count, MPI_Datatype type, void* received, const Count counts[],      \
    const Place places[], MPI_Datatype as, int root, MPI_Comm comm)                                                    \
  {                                                                                                                    \
    for (int rank = 0; RankIn(comm) == root && rank < RanksIn(comm); ++rank)                                           \
    {                                                                                                                  \
      Add(comm, rank, (uint64_t)counts[rank], as);                                                                     \
    }                                                                                                                  \
    return PMPI_Gatherv##SUFFIX(sent, count, type, received, counts, places, as, root, comm);                          \
  }                                                                                                                    \
                                                                                                                       \
  int MPI_Allgatherv##SUFFIX(const void* sent, Count count, MPI_Datatype type, void* received, const Count counts[],   \
    const Place places[], MPI_Datatype as, MPI_Comm comm)                                                              \
  {                                                                                                                    \
    for (int rank = 0; rank < RanksIn(comm); ++rank)                                                                   \
    {                                                                                                                  \
      Add(comm, rank, (uint64_t)counts[rank], as);                                                                     \
    }                                                                                                                  \
    return PMPI_Allgatherv##SUFFIX(sent, count, type, received, counts, places, as, comm);                             \
  }

CALLS(, int, int)
#if MPI_VERSION >= 4
CALLS(_c, MPI_Count, MPI_Aint)
#endif
