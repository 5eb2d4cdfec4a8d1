#include "cli/program.h"

int main(int argc, char** argv) { return lumaknot::run_program(argc, argv); }
