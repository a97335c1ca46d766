// SPDX-License-Identifier: MIT
#pragma once
// What the library uses of Windows, declared as Microsoft's documentation has it; no more than that.
#define INVALID_FILE_ATTRIBUTES 0xFFFFFFFFUL
#define FILE_ATTRIBUTE_DIRECTORY 0x10UL
#define MOVEFILE_REPLACE_EXISTING 0x1UL
#define MOVEFILE_WRITE_THROUGH 0x8UL
#define INFINITE 0xFFFFFFFFUL
extern "C" {
unsigned long GetFileAttributesA(const char* name);
int MoveFileExA(const char* from, const char* to, unsigned long flags);
void* CreateMutexA(void* attributes, int initially_owned, const char* name);
unsigned long WaitForSingleObject(void* handle, unsigned long milliseconds);
int ReleaseMutex(void* mutex);
int CloseHandle(void* handle);
}
