// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>

// Eigen aligns a pose by the vector instructions that a file is compiled for, and a struct that
// holds one has another size with AVX than without. Two files of one program that disagree would
// pass each other structs that they read differently, so the linker is made to refuse them: each
// width is a group of its own, of which one is kept, and all groups define the one symbol whose
// name the linker then shows. (ELF and GNU assembler syntax: elsewhere nothing checks.)
#if defined(__ELF__) && defined(__GNUC__)
#define TOPOBAG_TEXT_OF_(x) #x
#define TOPOBAG_TEXT_OF(x) TOPOBAG_TEXT_OF_(x)
// Not twice in one assembler file, as link-time optimisation joins several.
__asm__(".ifndef topobag_aligns_to_" TOPOBAG_TEXT_OF(EIGEN_MAX_STATIC_ALIGN_BYTES) "\n"
        ".pushsection .rodata.topobag_alignment,\"aG\",%progbits,"
        "topobag_aligns_to_" TOPOBAG_TEXT_OF(EIGEN_MAX_STATIC_ALIGN_BYTES) ",comdat\n"
        ".weak topobag_aligns_to_" TOPOBAG_TEXT_OF(EIGEN_MAX_STATIC_ALIGN_BYTES) "\n"
        "topobag_aligns_to_" TOPOBAG_TEXT_OF(EIGEN_MAX_STATIC_ALIGN_BYTES) ":\n"
        ".globl topobag_all_files_must_be_compiled_for_the_same_vector_instructions\n"
        ".hidden topobag_all_files_must_be_compiled_for_the_same_vector_instructions\n"
        "topobag_all_files_must_be_compiled_for_the_same_vector_instructions:\n"
        ".byte 0\n"
        ".popsection\n"
        ".endif\n");
#undef TOPOBAG_TEXT_OF
#undef TOPOBAG_TEXT_OF_
#endif
