// SPDX-License-Identifier: MIT
#pragma once
#define _O_WRONLY 0x1
#define _O_CREAT 0x100
#define _O_EXCL 0x400
#define _O_BINARY 0x8000
#define _O_NOINHERIT 0x80
#define _S_IREAD 0x100
#define _S_IWRITE 0x80
extern "C" {
int _open(const char* name, int flags, int mode);
int _write(int file, const void* bytes, unsigned count);
int _commit(int file);
int _close(int file);
char* _fullpath(char* absolute, const char* relative, decltype(sizeof(0)) size);
}
