// All uses of MPI are in this file, except initialisation and end.
#include "mpi/messages.hpp"

#include <chrono>
#include <cstring>
#include <mpi.h>
#include <thread>

namespace higherpair::cli {

std::int64_t Received::number() const {
  std::int64_t value = 0;
  if (bytes.size() == sizeof value) std::memcpy(&value, bytes.data(), sizeof value);
  return value;
}

std::optional<Received> receive() {
  int there = 0;
  MPI_Status status;
  MPI_Iprobe(MPI_ANY_SOURCE, MPI_ANY_TAG, MPI_COMM_WORLD, &there, &status);
  if (there == 0) {
    return std::nullopt;
  }
  int count = 0;
  MPI_Get_count(&status, MPI_BYTE, &count);
  Received received{static_cast<Message>(status.MPI_TAG), status.MPI_SOURCE,
                    std::string(static_cast<std::size_t>(count), '\0')};
  MPI_Recv(received.bytes.data(), count, MPI_BYTE, received.rank, status.MPI_TAG, MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return received;
}

void send(int rank, Message what, const std::string& bytes) {
  MPI_Send(bytes.data(), static_cast<int>(bytes.size()), MPI_BYTE, rank, static_cast<int>(what),
           MPI_COMM_WORLD);
}

void send(int rank, Message what, std::int64_t number) {
  send(rank, what, std::string(reinterpret_cast<const char*>(&number), sizeof number));
}

int own_rank() {
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int rank_count() {
  int count = 0;
  MPI_Comm_size(MPI_COMM_WORLD, &count);
  return count;
}

void rest() {
  std::this_thread::sleep_for(std::chrono::microseconds(100));
}

}  // namespace higherpair::cli
