// What `boxbeam sweep` needs of MPI, as a library that it loads where mpirun has started it.
// One thread at a time calls it.

#include <mpi.h>

namespace {

MPI_Win window = MPI_WIN_NULL;
long long* counter = nullptr;  ///< of the first process: the next number

}  // namespace

extern "C" {

/// Index and count of the processes; not 0 where MPI cannot begin.
int boxbeam_mpi_begin(int* index, int* count) {
  int given = 0;
  if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &given) != MPI_SUCCESS ||
      given < MPI_THREAD_SERIALIZED)
    return 1;
  MPI_Comm_rank(MPI_COMM_WORLD, index);
  MPI_Comm_size(MPI_COMM_WORLD, count);
  const MPI_Aint size = *index == 0 ? static_cast<MPI_Aint>(sizeof(long long)) : 0;
  MPI_Win_allocate(size, sizeof(long long), MPI_INFO_NULL, MPI_COMM_WORLD, &counter, &window);
  if (*index == 0) *counter = 0;
  MPI_Barrier(MPI_COMM_WORLD);
  MPI_Win_lock_all(0, window);
  return 0;
}

long long boxbeam_mpi_next() {
  const long long one = 1;
  long long number = 0;
  MPI_Fetch_and_op(&one, &number, MPI_LONG_LONG, 0, 0, MPI_SUM, window);
  MPI_Win_flush(0, window);
  return number;
}

void boxbeam_mpi_meet() { MPI_Barrier(MPI_COMM_WORLD); }

int boxbeam_mpi_any(int here) {
  int somewhere = 0;
  MPI_Allreduce(&here, &somewhere, 1, MPI_INT, MPI_MAX, MPI_COMM_WORLD);
  return somewhere;
}

/// Where MPI has no thread of its own it serves the others only while it is called.
void boxbeam_mpi_serve() {
  int there = 0;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, MPI_STATUS_IGNORE);
}

void boxbeam_mpi_end() {
  MPI_Win_unlock_all(window);
  MPI_Win_free(&window);
  MPI_Finalize();
}
}
