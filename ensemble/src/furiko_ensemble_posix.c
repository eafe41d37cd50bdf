/* SPDX-License-Identifier: MIT
 *
 * What a file needs beyond Fortran and HDF5: a lock that ends with its process, bytes that are surely there, bytes
 * that are surely on the disk. All return 0, or the errno that says why not. */
#define _GNU_SOURCE
#include <errno.h>
#include <fcntl.h>
#include <libgen.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* HDF5's own lock shuts out whoever only wants to look; ours below does not. A file that may not become so large is an
 * error of a write, as a full disk is, and no signal. Call before HDF5 begins. */
void ensemble_begin(void)
{
   setenv("HDF5_USE_FILE_LOCKING", "FALSE", 1);
   signal(SIGXFSZ, SIG_IGN);
}

/* writing: 0 to read, 1 to write what is there, 2 to make it where it is not */
int ensemble_open(const char *path, int writing, int *descriptor)
{
   const int flags[] = {O_RDONLY, O_RDWR, O_RDWR | O_CREAT};
   *descriptor = open(path, flags[writing] | O_CLOEXEC, 0666);
   return *descriptor < 0 ? errno : 0;
}

/* The lock is of one byte that no file has: MPI-IO by ROMIO locks the bytes that it writes, and would wait for ever. */
static const struct flock far_byte = {.l_type = F_WRLCK, .l_whence = SEEK_SET, .l_start = (off_t)1 << 62, .l_len = 1};

/* A lock of the open file, since a lock of the process would end as soon as HDF5 closes the file once.
 * -1: another process has it. */
int ensemble_lock(int descriptor)
{
   struct flock lock = far_byte;
   if (fcntl(descriptor, F_OFD_SETLK, &lock) == 0)
      return 0;
   return errno == EAGAIN || errno == EACCES ? -1 : errno;
}

int ensemble_is_locked(int descriptor)
{
   struct flock lock = far_byte;
   return fcntl(descriptor, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

int ensemble_reserve(int descriptor, long long offset, long long bytes)
{
   const int failed = posix_fallocate(descriptor, offset, bytes);
   return failed == EOPNOTSUPP ? 0 : failed;
}

int ensemble_sync(int descriptor) { return fsync(descriptor) < 0 ? errno : 0; }

/* A new name, on the disk as well */
int ensemble_rename(const char *from, const char *to)
{
   char folder[4096];
   int descriptor, failed;
   if (rename(from, to) < 0)
      return errno;
   snprintf(folder, sizeof folder, "%s", to);
   descriptor = open(dirname(folder), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
   if (descriptor < 0)
      return errno;
   failed = fsync(descriptor) < 0 ? errno : 0;
   close(descriptor);
   return failed;
}

int ensemble_remove(const char *path) { return unlink(path) < 0 ? errno : 0; }

/* 0 where there is such a file */
int ensemble_exists(const char *path) { return access(path, F_OK) < 0 ? errno : 0; }

int ensemble_is_terminal(int descriptor) { return isatty(descriptor); }

/* All of it to standard output */
int ensemble_write(const char *text, long long bytes)
{
   while (bytes > 0) {
      const ssize_t written = write(1, text, bytes);
      if (written < 0 && errno != EINTR)
         return errno;
      if (written > 0) {
         text += written;
         bytes -= written;
      }
   }
   return 0;
}

void ensemble_why(int number, char *text, int size) { snprintf(text, size, "%s", strerror(number)); }

/* Ends at once: HDF5 is not asked to write what it could not write before. */
void ensemble_end(int code)
{
   fflush(NULL);
   _exit(code);
}
