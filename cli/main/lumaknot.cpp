#include "cli/program.h"

int main(int argc, char** argv) { return lumaknot::cli::run_program(argc, argv); }
