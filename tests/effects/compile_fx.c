/* Compiles entry points of effects with the D3DCompile of d3dcompiler_47.
 *     compile_fx FILE ENTRY PROFILE [FILE ENTRY PROFILE]...
 * The disassembly goes to stdout, the compiler's messages to stderr; a form feed on both divides
 * one entry point from the next. Exit status 0, or 1 when an entry point was refused.
 */
#include <d3dcompiler.h>
#include <stdio.h>
#include <stdlib.h>

enum { kLargestSource = 1 << 22 }; /* bytes */

/* The whole file, or NULL; *size is its length in bytes. The caller frees it. */
static char* read_file(const char* path, size_t* size) {
  FILE* file = fopen(path, "rb");
  char* text = file ? malloc(kLargestSource) : NULL;
  if (text) *size = fread(text, 1, kLargestSource, file);
  if (file) fclose(file);
  return text;
}

/* Writes and frees a blob of text, or does nothing with NULL. Its size may include a final zero. */
static void print(FILE* stream, ID3DBlob* blob) {
  if (!blob) return;
  const char* text = ID3D10Blob_GetBufferPointer(blob);
  size_t size = ID3D10Blob_GetBufferSize(blob);
  while (size > 0 && text[size - 1] == '\0') --size;
  fwrite(text, 1, size, stream);
  ID3D10Blob_Release(blob);
}

/* Prints what failed and returns 1, or 0 when nothing did. */
static int failed(const char* what, const char* entry, const char* profile, HRESULT result) {
  if (SUCCEEDED(result)) return 0;
  fprintf(stderr, "%s as %s: %s failed with 0x%08lx\n", entry, profile, what,
          (unsigned long)result);
  return 1;
}

/* Compiles and disassembles one entry point: 0, or 1 when refused. */
static int compile(const char* path, const char* entry, const char* profile) {
  size_t size = 0;
  char* source = read_file(path, &size);
  if (!source) {
    fprintf(stderr, "cannot read %s\n", path);
    return 1;
  }
  ID3DBlob *code = NULL, *messages = NULL, *assembly = NULL;
  HRESULT result =
      D3DCompile(source, size, path, NULL, NULL, entry, profile, 0, 0, &code, &messages);
  free(source);
  print(stderr, messages);
  if (failed("D3DCompile", entry, profile, result)) return 1;

  result = D3DDisassemble(ID3D10Blob_GetBufferPointer(code), ID3D10Blob_GetBufferSize(code), 0,
                          NULL, &assembly);
  ID3D10Blob_Release(code);
  print(stdout, assembly);
  return failed("D3DDisassemble", entry, profile, result);
}

int main(int argc, char** argv) {
  if (argc < 4 || argc % 3 != 1) {
    fprintf(stderr, "usage: compile_fx FILE ENTRY PROFILE [FILE ENTRY PROFILE]...\n");
    return 1;
  }
  int refused = 0;
  for (int i = 1; i < argc; i += 3) {
    if (i > 1) fputc('\f', stdout), fputc('\f', stderr);
    refused |= compile(argv[i], argv[i + 1], argv[i + 2]);
  }
  return refused;
}
